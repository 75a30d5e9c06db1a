# What Doxygen reads of a header: `/// @file What it holds.` becomes a file and its brief (Doxygen would
# take the first word for a name), and a comment above functions that follow each other without an
# empty line is the comment of each.
/^ *\/\/\/ @file / {
  print "/// @file"
  sub(/@file /, "")
}

# The names of an enumeration are declared beside it, without a word of their own.
/^template <>$/ { held = $0; next }
held != "" { if (/^std::span<const Named</) { held = ""; print ""; print ""; next } print held; held = "" }

/^ *\/\/\// {
  if (!in_comment) comment = ""
  comment = comment $0 "\n"
  match($0, /^ */)
  comment_indent = RLENGTH
  in_comment = 1
  print
  next
}

/^ *$/ {
  comment = ""
}

{
  match($0, /^ */)
  begins = !in_comment && at_end && RLENGTH == comment_indent
  if (begins && comment != "" && /\(/ && !/\/\/\/</) printf "%s", comment
  in_comment = 0
  at_end = /[;}]( *\/\/.*)?$/
  print
}
