# design_names.pl STAMP ROOT HEADER...
#
# What a model may have beside its step is found by its name, so a misspelt one would silently be
# nothing. Reads the headers of a model and what they include with "...", and ends with status 2 and a
# line on standard error where a member of struct Design, or a function of (const Params&, const
# State<V>&, ...), has nearly the name of one that the harness looks for: by the edit distance of
# Damerau and Levenshtein, one edit away from a name of 4 or 5 letters, two from a longer one. What the
# harness looks for is read out of its headers below ROOT: Design::NAME, and NAME(p, s) where a
# `requires` or COSIM_STATED asks for it. Writes STAMP, and STAMP.d for ninja: the files it has read.
use strict;
use warnings;
use Cwd 'abs_path';
use File::Basename 'dirname';

my ($stamp, $root, @headers) = @ARGV;
my %renamed = (clear => 'reset_inputs', cleared => 'reset_state', clear_clocks => 'reset_clocks');

sub text_of {
  open(my $file, '<', $_[0]) or die "$_[0]: cannot be read\n";
  local $/;
  return scalar <$file>;
}

# The text with each piece turned into as many spaces: places stay what they are.
sub blank { my ($piece) = @_; $piece =~ s/[^\n]/ /g; return $piece }
sub plain {
  my ($text) = @_;
  $text =~ s{("(?:\\.|[^"\\\n])*"|(?<!\w)'(?:\\.|[^'\\\n])'|//[^\n]*|/\*.*?\*/)}{blank($1)}ges;
  return $text;
}

# The fewest letters put in, left out, changed, or swapped with the next one, that make $x to $y.
sub edits {
  my ($x, $y) = map { [split //, lc] } @_;
  my @d = map { [$_] } 0 .. @$x;
  $d[0] = [0 .. @$y];
  for my $i (1 .. @$x) {
    for my $j (1 .. @$y) {
      my $best = $d[$i - 1][$j - 1] + ($x->[$i - 1] ne $y->[$j - 1]);
      my @others = ($d[$i - 1][$j] + 1, $d[$i][$j - 1] + 1);
      push @others, $d[$i - 2][$j - 2] + 1
        if $i > 1 && $j > 1 && $x->[$i - 1] eq $y->[$j - 2] && $x->[$i - 2] eq $y->[$j - 1];
      for my $other (@others) { $best = $other if $other < $best }
      $d[$i][$j] = $best;
    }
  }
  return $d[@$x][@$y];
}

# The name that was meant, or nothing.
sub meant {
  my ($name, $known) = @_;
  return undef if $known->{$name};
  for my $one (sort keys %$known) {
    next if length $one < 4;
    return $one if edits($name, $one) <= (length $one < 6 ? 1 : 2);
  }
  return undef;
}

my (%members, %functions);
for my $header (glob(qq("$root/model/core/*.h" "$root/tb/*/*.h"))) {
  my $text = text_of($header);
  $members{$1} = 1 while $text =~ /\bDesign::(?:template )?(\w+)/g;
  $functions{$1} = 1 while $text =~ /\brequires\b[^{};]*\{\s*(\w+)\(p, s\b/g;
  $functions{$1} = 1 while $text =~ /\bCOSIM_STATED\(\w+, ([a-z]\w*)\)/g;
}

sub refuse {
  my ($file, $text, $at, $what, $meant) = @_;
  my $line = 1 + (substr($text, 0, $at) =~ tr/\n//);
  print STDERR "$file:$line: $what means nothing: is $meant meant?\n";
  exit 2;
}

# What stands in the braces of struct Design, but not in braces or parentheses in there.
sub check_members {
  my ($file, $text) = @_;
  while ($text =~ /\b(?:struct|class)\s+Design\b[^;{()]*\{/g) {
    my ($begin, $depth, $body) = (pos $text, 0, '');
    for my $c (split //, substr($text, $begin)) {
      last if $c eq '}' && $depth == 0;
      --$depth if $c =~ /[)}]/;
      $body .= $depth == 0 || $c eq "\n" ? $c : ' ';
      ++$depth if $c =~ /[({]/;
    }
    $body =~ s/(\btemplate\s*<[^>]*>|\b(?:public|private|protected)\s*:|\brequires\b[^;{]*)/blank($1)/ge;
    while ($body =~ /[^;}]+/g) {
      my ($at, $piece) = ($-[0], $&);
      next unless $piece =~ /\busing\s+(\w+)|\b(?:struct|class)\s+(\w+)|(\w+)\s*[({=\[]|(\w+)\s*$/;
      my $name = $1 // $2 // $3 // $4;
      my $meant = $renamed{$name} // meant($name, \%members) // next;
      refuse($file, $text, $begin + $at + $-[0], "$name in struct Design", $meant);
    }
  }
}

my (%read, @files);
sub check {
  my ($file) = @_;
  my $path = abs_path($file);
  return if $read{$path}++ || $path =~ m{^\Q$root\E/(model/core|tb)/};
  push @files, $path;
  my $text = text_of($file);
  for my $name ($text =~ /^[ \t]*#[ \t]*include[ \t]*"([^"\n]+)"/mg) {
    for my $folder (dirname($path), $root) {
      next unless -f "$folder/$name";
      check("$folder/$name");
      last;
    }
  }
  $text = plain($text);
  check_members($file, $text);
  while ($text =~ /\b(\w+)\s*\(\s*(?:const\s+)?(?:\w+::)*Params\b[^,()]*,\s*(?:const\s+)?(?:\w+::)*State\b/g) {
    my ($name, $at) = ($1, $-[1]);
    my $meant = meant($name, \%functions) // next;
    refuse($file, $text, $at, "$name(p, s, ...)", $meant);
  }
}

$root = abs_path($root);
check($_) for @headers;
s/([ #])/\\$1/g for @files;
for (["$stamp.d", "$stamp: @files\n"], [$stamp, '']) {
  open(my $file, '>', $_->[0]) or die "$_->[0]: cannot be written\n";
  print $file $_->[1];
}
