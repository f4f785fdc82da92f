# awk -f skips.awk JUNIT: a line for each test that ctest skipped, "NAME: REASON", in its own words.
# A reason that begins with "not here: " is something that the set-up of the tests does not bring: a
# folder or a right that only the user can give. All others, and a test without a reason, were to be
# prevented.
# Status: 0 none but those that begin so, 1 others.

function text(xml) {
  gsub(/&lt;/, "<", xml); gsub(/&gt;/, ">", xml); gsub(/&quot;/, "\"", xml)
  gsub(/&apos;/, "'", xml); gsub(/&amp;/, "\\&", xml)
  return xml
}

/<testcase / {
  name = $0
  sub(/.*<testcase name="/, "", name)
  sub(/".*/, "", name)
  skipped = reason = ""
  said = 0
}
/<skipped|status="(disabled|notrun)"/ { skipped = "yes" }
# A script's line, or what follows the place of a GTEST_SKIP().
{ line = $0; sub(/.*<system-out>/, "", line); sub(/<\/system-out>.*/, "", line) }
said && reason == "" { reason = line; said = 0 }
line ~ /^skipped: ./ { reason = substr(line, 10) }
line ~ /: Skipped$/ { said = 1 }
/<\/testcase>/ && skipped {
  print text(name) ": " (reason == "" ? "no reason" : text(reason))
  if (reason !~ /^not here: ./) preventable = 1
  skipped = ""
}
END { exit preventable }
