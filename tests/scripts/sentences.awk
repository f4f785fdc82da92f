# The sentences of pages and of help texts, a line each: FILE:LINE, a tab, the sentence. Fenced blocks
# are left out, `code` is "x", and a cell of a table or of two columns is a text of its own. Headings and
# texts of fewer than three words are no sentences.

function flush(   rest, one, words) {
  rest = text
  text = ""
  gsub(/`[^`]*`/, "x", rest)
  gsub(/!?\[/, "", rest)
  gsub(/\]\([^)]*\)/, "", rest)
  gsub(/\*\*/, "", rest)
  gsub(/[ \t]+/, " ", rest)
  while (rest != "") {
    if (match(rest, /[.!?:;]["')*]* /)) {
      one = substr(rest, 1, RSTART)
      rest = substr(rest, RSTART + RLENGTH)
      # "e.g. this" and "clock: a" go on.
      if (one !~ /[.!?]$/ || rest !~ /^["'(*]*[A-Zx0-9]/) {
        held = held one " "
        continue
      }
    } else {
      one = rest
      rest = ""
    }
    one = held one
    held = ""
    sub(/^ +/, "", one)
    if (split(one, words, " ") > 2) printf "%s\t%s\n", at, one
  }
}

# add TEXT: a text that begins here; more TEXT: it goes on.
function add(what) { flush(); at = FILENAME ":" FNR; text = what }
function more(what) { if (text == "") at = FILENAME ":" FNR; text = text " " what }

FNR == 1 { flush(); fenced = 0 }
/^```/ { flush(); fenced = !fenced; next }
fenced { next }
/^#/ || /^[[:space:]]*$/ || /^<!--/ { flush(); next }
/^[|]/ {
  flush()
  gsub(/\\[|]/, "or")
  n = split($0, cells, "|")
  for (i = 1; i <= n; ++i) if (cells[i] ~ /[a-z]/) add(cells[i])
  flush()
  next
}
/^ *([-*]|[0-9]+[.]) / { sub(/^ *([-*]|[0-9]+[.]) /, ""); add($0); next }
# Two columns, as a help has them.
match($0, /^ *-?[^ ]+( [^ ]+)*  +/) && FILENAME !~ /[.]md$/ { add(substr($0, RSTART + RLENGTH)); next }
{ more($0) }
END { flush() }
