# For vhdl.pl: puts right what GHDL 2.0 gets wrong where it prints its netlist as Verilog, or ends, by fail()
# of vhdl.pl, with the file and line of the VHDL.
use strict;
use warnings;

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
  $text =~ s/^(\w+) \((\d+)(?: downto (\d+))?\)$/$1 . (defined $3 ? "[$2:$3]" : "[$2]")/e;
  return $text =~ /^["']([01XZ]+)["']$/i ? length($1) . "'b$1" : $text;
}

# Ends where GHDL gives a signal no value that has one: a register that nothing but its reset writes, which is
# x in its Verilog, and bits that have their initial value alone. It warns of a signal that truly has none.
sub refuse_lost_values {
  my ($text, $said) = @_;
  while ($text =~ m{^  /\* (\S+:\d+):(\d+)  \*/\n  (?:assign|always \@\*\n   ) (\S+) = (\d+'bX+|.*); // \((i?)signal\)$}mg) {
    my ($place, $column, $name, $value, $has_initial) = ($1, $2, $3, $4, $5);
    my $is_x = $value =~ /'bX/;
    my ($warned) = $said =~ /^\Q$place:$column\E:warning: (signal "\Q$name\E" is never assigned|no assignment for offset)/m;
    fail("$place: GHDL gives $name no value: only its reset writes it, or nothing does")
      if $is_x && !$warned;
    fail("$place: GHDL loses the initial value of bits of $name that nothing writes")
      if $has_initial && ($warned // '') =~ /^no/;
  }
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

1;
