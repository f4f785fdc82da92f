# perl vhdl.pl TOP OUT.v [NAME=VALUE]... FILE.vhd...
#
# VHDL as plain Verilog, by GHDL: of the entity TOP with these generics, or, where a Verilog module is
# the top, of each entity that no other has an instance of. The module has parameters of the names of
# the generics, whose values are those that it was made with. GHDL keeps the names of signals as wires
# that copy a register n7_q; here the register has the name itself. Where GHDL leaves a case open, for a
# value that a type of the VHDL does not have, its last part holds. Says on stderr in one line what is wrong.
#
# GHDL 2.0 synthesizes some functions of numeric_std as something else: it is given copies of the files in
# which those of numeric.vhd stand in front of them. And its Verilog lacks some of what its netlist says, the
# default of a case for one. That is taken from the netlist as VHDL, which has the same names, or the file is
# refused, see vhdl_repair.pl.
use strict;
use warnings;
use File::Temp qw(tempdir);
use FindBin;
require "$FindBin::Bin/vhdl_repair.pl";

my ($top, $out, @rest) = @ARGV;
my %value;
while (@rest && $rest[0] =~ /^(\w+)=(.*)$/) { $value{lc $1} = $2; shift @rest }
my @files = @rest;
my $work = tempdir(CLEANUP => 1);

# A column behind what is put into a line is none of the file.
sub fail { print STDERR own_names($_[0]) =~ s/^(\S+:\d+):\d{4,}:/$1:/r, "\n"; exit 1 }

# What GHDL writes; its first error where it writes none.
sub ghdl {
  my ($command, @words) = @_;
  open my $pipe, '-|', 'sh', '-c', 'exec "$0" "$@" 2>"$WORK/said"', 'ghdl', $command, '--std=08',
    "--workdir=$work", @words or fail("needs ghdl");
  my $text = do { local $/; <$pipe> } // '';
  close $pipe;
  return $text if $? == 0;
  my @said = split /^/, text_of("$work/said");
  fail('needs ghdl, which turns VHDL into Verilog') if $? >> 8 == 127;
  my ($error) = grep { /^\S+:\d+:\d+: ?(?!note|warning)/ } @said;
  ($error) = grep { /\S/ && !/^\*+/ } @said if !$error;
  chomp($error //= 'ghdl says nothing');
  $error =~ s/\d+: redeclaration of non-object alias ("\S+").*/ declares $1 of numeric_std anew: give it another name/;
  fail($error);
}
$ENV{WORK} = $work;

# What names a copy names the file.
sub own_names { return $_[0] =~ s/\Q$work\E\/(\d+)\.vhd/$files[$1]/gr }

# Entities with their generics of a literal default, and who has an instance of whom.
my (%entity, %generics, %used);
for my $file (@files) {
  (my $text = text_of($file)) =~ s/--[^\n]*//g;
  while ($text =~ /\bentity\s+(\w+)\s+is\b(.*?)\bend\b/gis) {
    my ($name, $body) = ($1, $2);
    $entity{lc $name} = $name;
    next unless $body =~ /\bgeneric\s*\((.*?)\)\s*;\s*(?:port|$)/is;
    for my $one (split /;/, $1) {
      my ($names, $default) = $one =~ /^\s*(?:constant\s+)?([\w\s,]+?)\s*:\s*[^:]+?(?::=\s*(\S.*?))?\s*$/s
        or next;
      push @{$generics{lc $name}}, [$_, $default] for split /\s*,\s*/, $names;
    }
  }
  $used{lc $1} = 1 while $text =~ /:\s*(?:entity\s+\w+\.|component\s+)?(\w+)\s*(?:\(\s*\w+\s*\)\s*)?(?:generic|port)\s+map\b/gi;
}
fail("$files[0]: no entity") if !%entity;
my $is_top = exists $entity{lc $top};
my @roots = $is_top ? lc $top : grep { !$used{$_} } sort keys %entity;

sub text_of { open my $in, '<', $_[0] or fail("$_[0]: cannot be read"); local $/; return <$in> // '' }
sub write_text {
  my ($name, @text) = @_;
  open my $to, '>', $name or fail("$name: cannot be written");
  print $to @text;
  close $to or fail("$name: cannot be written");
}

# The names of numeric.vhd, which an architecture and a package body declare first.
my $numeric = "$FindBin::Bin/numeric.vhd";
my ($aliases, %replaced) = '';
my $on_vectors = grep { text_of($_) =~ /\bnumeric_std_unsigned\b/i } @files;
for my $line (text_of($numeric) =~ /^  function ((?!wide)\S+ \([^)]*\) return \w+);$/mg) {
  my ($name, $arguments, $result) = $line =~ /^(\S+) \((.*)\) return (\w+)/;
  next if $arguments =~ /std_ulogic_vector/ && !$on_vectors;
  my @types = map { s/^(?=(?:un)?signed$)/ieee.numeric_std./r =~ s/^(?=std_ulogic)/ieee.std_logic_1164./r }
    $arguments =~ /: (\w+)/g, $result;
  $aliases .= " alias $name is work.cosim_numeric.$name [" . join(', ', @types[0 .. $#types - 1]) . " return $types[-1]];";
  $replaced{$name} = 1;
}
my @copies;
for my $file (@files) {
  my $text = text_of($file);
  my $used = qr/\bnumeric_std\s*\.\s*(?=\w+\s*\(|")/i;
  (my $plain = $text) =~ s/--[^\n]*//g;
  while ($plain =~ /$used("[^"]+"|\w+)/g) {
    my $name = lc $1;
    my $line = 1 + substr($plain, 0, $-[0]) =~ tr/\n//;
    fail("$file:$line: numeric_std.$name: GHDL reads it wrong: write it without numeric_std") if $replaced{$name};
  }
  $text =~ s{(--[^\n]*|"[^"\n]*"|'.')|\b((?:architecture\s+\w+\s+of\s+[\w.]+|package\s+body\s+\w+)\s+is\b)}
            {$1 // "library ieee; $2$aliases"}gie;
  push @copies, "$work/" . @copies . '.vhd';
  write_text($copies[-1], $text);
}
ghdl('-i', @copies, $numeric);
my (%done, @modules);
for my $root (@roots) {
  ghdl('-m', $root);
  my @generics = $is_top ? map { "-g$_=$value{$_}" } sort keys %value : ();
  my $text = ghdl('--synth', '--out=verilog', @generics, $root);
  refuse_lost_values($text, text_of("$work/said"));
  my $netlist;
  for my $module (split /^(?=module )/m, $text) {
    my ($name) = $module =~ /^module (\S+)/ or next;
    next if $done{$name}++;
    $netlist //= netlist(ghdl('--synth', '--out=vhdl', @generics, $root)) if $module =~ /^    case|or posedge|; \/\/ (?:pos|neg)edge$/m;
    $module = repaired($module, $netlist->{lc $name});
    push @modules, own_names(plain($module, $is_top && lc $name eq $root ? $root : undef));
  }
}
# Small letters, for VHDL knows no others; the top as it is asked for.
for my $name (grep { $_ ne lc } keys %done) {
  my $small = lc $name eq lc $top ? $top : lc $name;
  s/^(module |  )\Q$name\E(?=\s)/$1$small/mg for @modules;
}
write_text($out, "// Made by GHDL from VHDL.\n/* verilator lint_off DECLFILENAME */\n",
  "/* verilator lint_off UNUSED */\n\n", @modules);

# A module with registers by the names of their signals, and with parameters.
sub plain {
  my ($text, $root) = @_;
  my %is_reg = map { $_ => 1 } $text =~ /^  reg (?:\[\d+:0\] )?(\w+);$/mg;
  # A register that goes by one other name has that.
  my %copies;
  $text =~ s{^  always \@\*\n    (\w+) = ([\w']+); // \(isignal\)\n  initial\n    \1 <= [^;]*;\n}
            {  assign $1 = $2; // (signal)\n}mg;
  push @{$copies{$2}}, $1 while $text =~ m{^  assign (\w+) = (n\d+_q); // \(signal\)$}mg;
  for my $register (keys %copies) {
    my ($signal, @more) = @{$copies{$register}};
    next if @more || !$is_reg{$register};
    my $name = $signal;
    $name = $1 if $signal =~ /^n\d+_(\w+)$/ && $text !~ /\b$1\b/;
    $text =~ s{^  assign $signal = $register; // \(signal\)\n}{}m;
    $text =~ s/^  (?:wire|reg) (?:\[\d+:0\] )?$signal;\n//m;
    $text =~ s/\b(?:$register|$signal)\b/$name/g;
  }
  # What a register takes stands where it takes it: a reset is to be seen there.
  for my $net ($text =~ /^ +\w+ <= (n\d+_o);$/mg) {
    my @all = $text =~ /\b$net\b/g;
    next if @all != 3 || $text !~ /^  assign $net = (.*);$/m;
    my $value = $1;
    $text =~ s/^  (?:assign $net = .*|wire (?:\[\d+:0\] )?$net);\n//mg;
    $text =~ s/ <= $net;$/ <= $value;/m;
  }
  $text =~ s/^  initial\n    \S+ <= \d+'bX+;\n//mg;
  $text =~ s/^(  initial\n    \S+) <= /$1 = /mg;
  # The last of a case stands for all others, too: what is left open is no latch.
  $text =~ s{^(    case \((?:(?!endcase).)*?)^(    endcase)}{
    my ($case, $end) = ($1, $2);
    $case =~ s/ <= / = /g;
    $case =~ s/^      \S+:(?= [^\n]*\n\z)/      default:/m if $case !~ /^      default:/m;
    "$case$end"
  }mgse;
  if (defined $root) {
    my @parameters;
    for my $one (@{$generics{$root} // []}) {
      my ($name, $value) = ($one->[0], $value{lc $one->[0]} // $one->[1] // next);
      push @parameters, "parameter $name = $value" if $value =~ /^-?\d+$/;
      push @parameters, "parameter $name = \"$1\"" if $value !~ /^-?\d+$/ && $value =~ /^"?([\w.:+-]+)"?$/
        && exists $value{lc $name};
    }
    $text =~ s/\n/"\n  #(" . join(', ', @parameters) . ")\n"/e if @parameters;
  }
  return $text;
}
