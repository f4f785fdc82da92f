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
# refused, see repaired().
use strict;
use warnings;
use File::Temp qw(tempdir);
use FindBin;

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
  open my $in, '<', "$work/said" or fail('ghdl says nothing');
  my @said = <$in>;
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

sub text_of { open my $in, '<', $_[0] or fail("$_[0]: cannot be read"); local $/; return <$in> }

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
  open my $to, '>', $copies[-1] or fail("$copies[-1]: cannot be written");
  print $to $text;
  close $to;
}
ghdl('-i', @copies, $numeric);
my (%done, @modules);
for my $root (@roots) {
  ghdl('-m', $root);
  my @generics = $is_top ? map { "-g$_=$value{$_}" } sort keys %value : ();
  my $text = ghdl('--synth', '--out=verilog', @generics, $root);
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
open my $to, '>', $out or fail("$out: cannot be written");
print $to "// Made by GHDL from VHDL.\n/* verilator lint_off DECLFILENAME */\n",
  "/* verilator lint_off UNUSED */\n\n", @modules;
close $to or fail("$out: cannot be written");

# By modules, from GHDL's netlist as VHDL: the defaults of cases, the initial values of registers, and the
# clocks of nets that are an edge.
sub netlist {
  my %module;
  for my $text (split /^(?=architecture )/m, $_[0]) {
    my ($name) = $text =~ /^architecture \w+ of (\S+) is/ or next;
    my $of = $module{lc $name} = {};
    $of->{initial}{$1} = constant($2) while $text =~ /^  signal (n\d+_q) : [^;]*? := ([^;]*);$/mg;
    while ($text =~ /^  with \S+ select (\w+) <=\n(?:    .*,\n)*    (.*) when others;$/mg) {
      my ($target, $value) = ($1, $2);
      $of->{default}{$target} = constant($value =~ s/^wrap_(?=\w)//r);
    }
    $of->{edge}{$1} = ($2 eq 'rising' ? 'posedge ' : 'negedge ') . $3
      while $text =~ /^  (\w+) <= '1' when (rising|falling)_edge \((?:wrap_)?(\w+)\) else '0';$/mg;
  }
  return \%module;
}

# A literal of VHDL as one of Verilog; another word as it is.
sub constant {
  my ($text) = @_;
  return $text =~ /^["']([01XZ]+)["']$/i ? length($1) . "'b$1" : $text;
}

# A module as GHDL wrote it, with what its printer of Verilog gets wrong put right. Ends where it cannot be.
sub repaired {
  my ($text, $of) = @_;
  my $word = qr/(?:\w+|\d+'b\w+)/;
  my $bits = qr/\$(?:un)?signed\(($word)\)/;
  # More than 32 bits are a string, which has eight bits a digit.
  $text =~ s/"([01XZ]+)"/length($1) . "'b$1"/ge;
  # Operators of signed numbers, and some that are VHDL.
  $text =~ s{ = ($word) / ($word); // sdiv$}{ = \$signed($1) / \$signed($2); // sdiv}mg;
  $text =~ s{ = ($word) % ($word); // srem$}{ = \$signed($1) % \$signed($2); // srem}mg;
  $text =~ s{ = ($word) % ($word); // smod$}{my ($x, $y, $r) = ("\$signed($1)", "\$signed($2)");
    $r = "$x % $y"; " = ($x < 0) == ($y < 0) || $r == 0 ? $r : $r + $y; // smod"}mge;
  $text =~ s/( = \$signed\($word\)) >> /$1 >>> /g;
  $text =~ s/^  (\w+) <= std_logic_vector\(abs $bits\);$/  assign $1 = \$signed($2) < 0 ? -$2 : $2;/mg;
  $text =~ s/^  (\w+) <= ($word) when $bits ([<>]) $bits else ($word);$/  assign $1 = \$signed($3) $4 \$signed($5) ? $2 : $6;/mg;
  $text =~ s/^  (\w+) <= std_logic_vector \((?:resize ?\()?$bits(?:, \d+\))? \+ (?:resize ?\()?$bits(?:, \d+\))?\);$/  assign $1 = $2 + $3;/mg;
  $text =~ s/^  (\w+) <= ($word); -- \((?:port|nop)\)$/  assign $1 = $2;/mg;
  my %width = reverse $text =~ /^  wire (?:\[(\d+):0\] )?(\w+);$/mg;
  my $turn = sub { my ($to, $x, $n, $by, $back) = @_; my $w = ($width{$to} // 0) + 1;
    "  assign $to = $x $by ($n % $w) | $x $back ($w - $n % $w);" };
  $text =~ s/^  (\w+) <= std_logic_vector \(rotate_left \($bits, to_integer \($bits\)\)\);$/$turn->($1, $2, $3, '<<', '>>')/mge;
  $text =~ s/^   gate_ror inst_\d+ \(\n    \.a\(($word)\),\n    \.b\(($word)\),\n    \.o\((\w+)\)\);$/$turn->($3, $1, $2, '>>', '<<')/mge;
  # An assertion has lost its severity, and an assumption is no Verilog.
  $text =~ s/^  always \@\*\n    if \(!\S+\)\n      \$fatal\(.*\);\n//mg;
  $text =~ s/^  \S+: assert .*; --  (?:assume|cover)\n//mg;
  # The default of a case, and the initial value of a register with an asynchronous reset.
  $text =~ s{^(    case \(\w+\)\n      \d+'b1?0*: (\w+) <= (?:.*\n)*?)(    endcase)$}{
    my ($case, $target, $end) = ($1, $2, $3);
    my $default = $of->{default}{$target};
    defined $default && $default !~ /'b[X-]+$/i ? "$case      default: $target <= $default;\n$end" : "$case$end"}mge;
  $text =~ s{^(  always \@\(.* or posedge \w+\)\n.*\n      (\w+) <= .*\n    else\n.*\n)}{
    my ($process, $register) = ($1, $2);
    my $value = $of->{initial}{$register};
    defined $value ? "$process  initial\n    $register <= $value;\n" : $process}mge;
  $text = with_memories_in_order(with_registers_for_edges($text, $of));
  if ($text =~ m{^( *(?!//|/\*)\S.*(?:<unassigned>|\*(?:err|nil)\*|std_logic_vector|\bgate_|-- \(|//\(dyn_extract\)| when | = "";).*)$}m) {
    my ($line, $before) = ($1, substr $text, 0, $-[0]);
    my ($place) = reverse $before =~ m{^  /\* (\S+:\d+):\d+  \*/$}mg;
    fail(($place // 'VHDL') . ": GHDL writes it as no Verilog: $line");
  }
  return $text;
}

# A register that is written at an index is a loop through an edge, which GHDL writes as 0: with the edge as
# 1 the loop is what the register takes. Ends where an edge is used for anything else.
sub with_registers_for_edges {
  my ($text, $of) = @_;
  my (%users, %signal);
  while ($text =~ m{^(?:  assign (\w+) = (.*);.*|  always \@\*\n    (\w+) = (\w+); // \(isignal\)|  always \@\*\n    case \(.*\)\n      \S+ (\w+) <=((?:.*\n)*?)    endcase)$}mg) {
    my ($net, $value) = ($1 // $3 // $5, $2 // $4 // $6);
    ($value) = $& =~ /always(.*)/s if defined $5;
    $signal{$net} = $value if $& =~ m{// \(i?signal\)$};
    push @{$users{$_}}, $net for $value =~ /\b[a-z_]\w*/gi;
  }
  my $reach = sub {  # the nets and the signals that follow from a net, but not through a signal
    my (%seen, @next) = (); @next = @{$users{$_[0]} // []};
    while (defined(my $net = shift @next)) { push @next, @{$users{$net} // []} if !$seen{$net}++ && !exists $signal{$net} }
    return \%seen;
  };
  while ($text =~ m{^  /\* (\S+:\d+):\d+  \*/\n  assign (\w+) = 1'b0; // (?:pos|neg)edge$}mg) {
    my ($place, $edge, $seen, %follows) = ($1, $2, $reach->($2));
    $follows{$_} = $reach->($_) for keys %$seen;
    my @registers = grep { exists $signal{$_} } keys %$seen;
    my $clock = $of->{edge}{$edge};
    # A register that takes a net is none of these if it does so on the same edge.
    (my $rest = $text) =~ s/^  always \@\($clock\)\n    \w+ <= \w+;\n//mg if $clock;
    my @stray = grep {
      exists $signal{$_} ? !$follows{$_}{$_} : $follows{$_}{$_} || $rest =~ /(?:<= |\()$_\b(?!\()|^   output .*\b$_\b/m
    } keys %$seen;
    fail("$place: GHDL makes no register of what this edge writes") if !$clock || !@registers || @stray;
    for my $register (@registers) {
      $text =~ s{^  assign $register = (\w+); // \(signal\)$}{  always \@($clock)\n    $register <= $1;}m
        or $text =~ s{^  always \@\*\n    $register = (\w+); // \(isignal\)$}{  always \@($clock)\n    $register <= $1;}m;
      $text =~ s/^  wire (?=(?:\[\d+:0\] )?$register;$)/  reg /m;
    }
    $text =~ s{^(  assign $edge = )1'b0}{${1}1'b1}m;
  }
  return $text;
}

# The accesses of a memory in their order: a read behind a write on the same edge sees what is written, and of
# two writes at one address the last one stays.
sub with_memories_in_order {
  my ($text) = @_;
  my (%written, %all);
  $text =~ s{^  always \@\((\w+ \w+)\)\n    if \((\S+)\)\n      (?:(\w+)\[(\S+)\] <= (\S+)|(\w+) <= (\w+)\[(\S+)\]);\n}{
    my ($clock, $enable, $memory, $at, $data, $to, $from, $place) = ($1, $2, $3, $4, $5, $6, $7, $8);
    if (defined $memory) {
      push @{$written{"$memory $clock"}}, [$enable, $at, $data];
      $all{"$memory $clock"} .= "    if ($enable)\n      $memory\[$at] <= $data;\n";
      "<writes $memory $clock>\n";
    } else {
      my $value = "$from\[$place]";
      $value = "($_->[0] && $_->[1] == $place ? $_->[2] : $value)" for @{$written{"$from $clock"} // []};
      "  always \@($clock)\n    if ($enable)\n      $to <= $value;\n";
    }
  }mge;
  $text =~ s{^<writes (\w+ (\w+ \w+))>\n}{my $writes = delete $all{$1};
    defined $writes ? "  always \@($2) begin\n$writes  end\n" : ''}mge;
  return $text;
}

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
