# What pages show of the project, a line each, where it stands first: FILE:LINE, a tab, the kind, a tab,
# the text.
#   command  a call of a script or of the program, in a block of commands or as `code` in a sentence
#   option   --NAME in a sentence, of some command
#   path     a file or folder of the project
# In a fenced block a command begins its line, or stands behind "$ " where what it prints follows.
# Blocks of other languages are not searched.

function say(kind, what) {
  if (!said[kind, what]++) printf "%s:%d\t%s\t%s\n", FILENAME, FNR, kind, what
}

function paths(text,   words, n, i) {
  n = split(text, words, /[ ,;()=]+/)
  for (i = 1; i <= n; ++i) {
    sub(/[:.]$/, "", words[i])
    if (words[i] ~ /^(rtl|model|tb|tests|scripts|docs|examples)\//) say("path", words[i])
  }
}

# call TEXT: whether it is a command; then it is said, without variables before it and a comment behind.
function call(text) {
  sub(/^ +/, "", text)
  while (text ~ /^[A-Z_]+=[^ ]* /) sub(/^[^ ]* /, "", text)
  if (text !~ /^(scripts\/[a-z]+|build\/([a-z]+\/)?[a-z_]+|(~\/cosim\/bin\/)?cosim [a-z-])/) return 0
  sub(/ +# .*/, "", text)
  say("command", text)
  paths(text)
  return 1
}

FNR == 1 { fenced = 0 }
/^```/ {
  fenced = !fenced
  language = substr($0, 4)
  next
}
fenced {
  begins = language == "sh" || language == "" && $0 !~ /^cosim /
  if (language != "console" && !begins || language == "console" && $0 !~ /^\$ /) next
  sub(/^\$ /, "")
  n = split($0, parts, / && /)
  for (i = 1; i <= n; ++i) call(parts[i])
  next
}
{
  rest = $0
  while (match(rest, /`[^`]+`/)) {
    code = substr(rest, RSTART + 1, RLENGTH - 2)
    rest = substr(rest, RSTART + RLENGTH)
    if (code ~ /^--[a-z]/) say("option", code)
    else if (!call(code)) paths(code)
  }
}
