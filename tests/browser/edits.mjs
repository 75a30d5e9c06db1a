// What a hand does in a page that is edited.

export const field = (page, key) => page.locator(`[data-field="${key}"]`);

// Takes the handle of a joint in a page that is edited by so many pixels.
export async function drag(page, joint, [x, y]) {
  const box = await page.locator(`[data-joint="${joint}"]`).boundingBox();
  const [left, top] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(left, top);
  await page.mouse.down();
  await page.mouse.move(left + x, top + y, { steps: 5 });
  await page.mouse.up();
}

export async function edit(page) {
  await page.locator(".edit-toggle").click();
  await page.locator("#edit").waitFor();
}

// Types into a field of the panel of edits.
export async function type(page, key, number) {
  await field(page, key).fill(String(number));
  await field(page, key).press("Tab");
}
