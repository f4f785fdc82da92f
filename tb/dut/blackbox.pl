# perl blackbox.pl TOP FOLDER NAME,NAME... FILE...
#
# Verilog without modules that no file has. In place of an instance `u` of the module NAME the design has a
# port for each of its pins: u$PIN, an input of TOP for an output of NAME, and an output for an input. One
# that lies deeper has its path before it: core$u$PIN. A file may say which pin is which, by a module NAME
# whose body is not read; without one a pin is an output where nothing else drives the net that it is joined
# to. Files that change are written into FOLDER, the rest is as of inout.pl.
# With COSIM_BLACKBOX=all what an instance is given besides nets is an output too: constants at pins, parameters
# (u$parameter$NAME) and attributes (u$attribute$NAME); and of pins of which none is known to drive their net the
# first does.
use strict;
use warnings;
use FindBin;
require "$FindBin::Bin/verilog_text.pl";

our ($group, $select, %words, %module);
my ($top, $folder, $boxes, @files) = @ARGV;
read_modules(@files);
my %box = map { $_ => 0 } split /,/, $boxes;    # whether there is one
my $is_all = ($ENV{COSIM_BLACKBOX} // '') eq 'all';
my %done;

# The ports of a module: name => [way, range].
sub ports_of {
    my ($m) = @_;
    my ($flat, $head, $is_ansi, @items) = head_of($m);
    my (%ports, $way, $range);
    my @declared = $is_ansi ? map { $_->[0] } @items : ();
    while (!$is_ansi && $flat =~ /\b((?:input|output|inout)\b[^;]*);/g) {
        push @declared, map { $_->[0] } parts($1, 0);
    }
    for my $text (@declared) {
        ($way, $range) = ($1, '') if $text =~ s/^(input|output|inout)\b//;
        $range = $1 if $text =~ s/^(?:\s*(?:wire|reg|logic|tri[01]?|signed)\b)*((?:\s*\[[^\]]*\])*)\s*(?=\w)// && $1 ne '';
        $ports{$1} = [$way, $range] if defined $way && $text =~ /^\s*(\w+)/;
    }
    return \%ports;
}
# All instances of a module: [name, pins, where it begins and ends, where its last parenthesis is].
sub instances {
    my ($of, $flat) = @_;
    my @all;
    while ($flat =~ /\b\Q$of\E\b\s*(?:#\s*$group)?\s*(\w+)\s*(\[[^\]]*\])?\s*$group\s*;/g) {
        my ($name, $many, $pins, $at, $end, $pins_at) = ($2, $3, $4, $-[0], $+[0], $-[4]);
        my $given = defined $1 ? [$-[1] + 1, length($1) - 2] : undef;    # within its parentheses
        fail("$of $name: instances of it as an array") if defined $many;
        # Blocks that are open here, and whether a loop makes one of them many.
        my @open;
        my $before = substr $flat, 0, $at;
        while ($before =~ /\b(?:(for)\s*$group\s*(?:begin\b)?|begin\b|(end)\b)/g) {
            if (defined $3) { pop @open } else { push @open, defined $1 }
        }
        fail("$of $name: instances of it in a loop") if grep { $_ } @open;
        my @pins = parts($pins =~ s/^\(|\)$//gr, $pins_at + 1);
        fail("$of $name: its pins are given in their order") if @pins && $pins[0][0] !~ /^\./;
        push @all, [$name, \@pins, $at, $end, $pins_at + length($pins) - 1, $given];
    }
    return @all;
}
sub joined {
    return map { $_->[0] =~ /^\.\s*(\w+)\s*(?:\((.*)\))?$/s ? [$1, ($2 // $1) =~ s/^\s+|\s+$//gr] : () } @_;
}
# What a parameter or an attribute is given as a constant of Verilog: [what kind it is, range, value]. Of other kinds
# other ports are made: a text is no number, and digits with an x and real numbers are taken as texts.
sub constant_of {
    my ($e) = @_;
    my ($kind, $bits) = ('', 256);
    my $real = qr/\d\.\d|(?<![\w'.])\d[\d_]*[eE][-+]?\d/;
    if ($e =~ /^"[^"]*"$/) { $kind = 'text' }
    elsif ($e !~ /"/ && $e =~ $real) {
        my $plain = $e =~ s/_//gr;
        $e = sprintf '%.17g', $plain if $plain =~ /^[-+]?[\d.]+(?:[eE][-+]?\d+)?$/;
        ($kind, $e) = ('real', "\"$e\"");
    } elsif ($e =~ /^\d*\s*'s?[bodh][\da-f_]*[xz?]/i) { ($kind, $e) = ('bits', '"' . lc($e) . '"') }
    elsif ($e =~ /^[^"]*(?<![\w'])[A-Za-z_`]/) {
        # A name may stand for a real number, which would be rounded, and for an integer or a text, of which an odd
        # multiple says as much.
        ($bits, $e) = (2048, "($e) * 1000003");
    }
    for my $size ($kind ? 8 * length $e : $e =~ /(\d+)\s*'/g) { $bits = $size if $size > $bits }
    return [$kind, '[' . ($bits - 1) . ':0]', $e];
}

# Whether something but a blackbox drives a net.
sub is_driven {
    my ($flat, $ports, $net) = @_;
    my $way = ($ports->{$net} // [''])->[0];
    return 1 if $way eq 'input' || $way eq 'inout' || $flat =~ /\b(?:reg|integer)\b[^;]*\b\Q$net\E\b/;
    return 1 if $flat =~ /\b(?:assign|wire|logic)\b[^;=]*\b\Q$net\E$select\s*(?:,[^;=]*\}\s*)?=(?!=)/;
    return 1 if $flat =~ /(?:[;):]|\bbegin|\belse)\s*\Q$net\E$select\s*<?=(?!=)/;
    for my $name (grep { !exists $box{$_} && $flat =~ /\b\Q$_\E\b/ } keys %module) {
        my $of = ports_of($module{$name});
        while ($flat =~ /\b\Q$name\E\b\s*(?:#\s*$group)?\s*\w+\s*(?:\[[^\]]*\])?\s*$group\s*;/g) {
            for my $pin (joined(parts($2 =~ s/^\(|\)$//gr, 0))) {
                return 1 if ($of->{$pin->[0]} // [''])->[0] ne 'input' && $pin->[1] =~ /\b\Q$net\E\b/;
            }
        }
    }
    return 0;
}
# The range of what a pin is joined to. Where $is_all, what is not known is wide: so nothing of it is cut.
my $vector = qr/wire|reg|logic|bit|tri(?:0|1|and|or|reg)?|wand|wor|uwire|var/;
my %bits = (integer => 32, int => 32, byte => 8, shortint => 16, longint => 64, time => 64);
sub range_of {
    my ($flat, $ports, $e, $where) = @_;
    my ($net, $part) = $e =~ /^[~\s]*(\w+)($select)$/;
    fail("$where is joined to '$e', and only a net, or its inverse, tells how wide it is") if !defined $net;
    return $1 =~ /^(.*):(.*)$/s ? "[($1) - ($2):0]" : '' if $part =~ /\[([^\]]*)\]\s*$/;
    return $ports->{$net}[1] if $ports->{$net};
    (my $plain = $flat) =~ s/\b(?:struct|union)\b[^{;]*\{[^{}]*\}//g;
    my %ranges;
    while ($plain =~ /\b(?:$vector)\b(?:\s*(?:$vector|signed|unsigned)\b)*((?:\s*\[[^\]]*\])*)[\s\w,]*\b\Q$net\E\b/g) {
        $ranges{$1} = 1;
    }
    while ($plain =~ /\b(integer|int|byte|shortint|longint|time)\b(?:\s*(?:un)?signed\b)?[\s\w,]*\b\Q$net\E\b/g) {
        $ranges{'[' . ($bits{$1} - 1) . ':0]'} = 1;
    }
    return (keys %ranges)[0] if keys %ranges == 1;
    return $is_all ? '[1023:0]' : '' if !%ranges;
    return '[1023:0]' if $is_all;
    fail("$where is joined to $net, of which there are several widths");
}

sub given {
    my ($name, $e) = @_;
    my ($kind, $range, $value) = @{constant_of($e =~ s/^\s+|\s+$//gr)};
    return [$kind ? "$name\$$kind" : $name, $range, $value];
}

# Takes the blackboxes out of a module and of those below it; its new ports, [name, way, range].
sub open_module {
    my ($m) = @_;
    return if $done{$m->{name}}++;
    $m->{opened} = [];
    my ($flat, $head, $is_ansi, @items) = head_of($m);
    my $ports = ports_of($m);
    my (@new, %driver);
    for my $of (sort keys %box) {
        my $declared = $module{$of} && ports_of($module{$of});
        for my $instance (instances($of, $flat)) {
            my ($name, $pins, $at, $end, undef, $given) = @$instance;
            my $text = '';
            my @constants;    # [name, range, value]
            my @joined = joined(@$pins);
            fail("$of $name: its pins are not all .PIN(NET)") if @joined != @$pins;
            $box{$of} = 1;
            for my $pin (@joined) {
                my ($port, $e) = @$pin;
                if ($e eq '' || $e =~ /^\d+$|^\d*\s*'/) {
                    my $range = $e =~ /^(\d+)\s*'/ ? '[' . ($1 - 1) . ':0]' : '[31:0]';
                    push @constants, [$port, $range, $e] if $e ne '';
                    next;
                }
                my $is_out = $declared ? ($declared->{$port} // [''])->[0] eq 'output'
                  : $e =~ /^(\w+)$select$/ && !is_driven($flat, $ports, $1);
                if ($is_out && !$declared && $is_all) {    # of pins on one net the first drives it
                    my ($first) = sort map { $_->[1] eq $e ? $_->[0] : () } @joined;
                    $is_out = ($driver{$e} //= "$name\$$first") eq "$name\$$port";
                }
                my $range = range_of($flat, $ports, $e, "$of $name: its pin $port");
                push @new, ["$name\$$port", $is_out ? 'input' : 'output', $range];
                $text .= $is_out ? "assign $e = $name\$$port; " : "assign $name\$$port = $e; ";
            }
            # Attributes before it, which stand for the instance, go with it.
            my $attributes =
              original($m, 0, $at) =~ m{((?:\(\*(?:(?!\*\)).)*\*\)|//[^\n]*\n|/\*(?:(?!\*/).)*\*/|\s)+)$}s ? $1 : '';
            $at -= length $attributes;
            $attributes = without_comments($attributes);
            my $count = 0;
            for my $one ($given ? parts(without_comments(original($m, @$given)), 0) : ()) {
                my ($parameter, $value) =
                  $one->[0] =~ /^\.\s*(\w+)\s*\((.*)\)$/s ? ($1, $2) : ($count++, $one->[0]);
                push @constants, given("parameter\$$parameter", $value);
            }
            while ($attributes =~ /[(*,]\s*([A-Za-z_]\w*)\s*(?:=\s*("[^"]*"|[^,*"]+?))?\s*(?=,|\*\))/g) {
                push @constants, given("attribute\$$1", $2 // '1');
            }
            for my $constant ($is_all ? @constants : ()) {
                my ($what, $range, $value) = @$constant;
                push @new, ["$name\$$what", 'output', $range];
                $text .= "assign $name\$$what = $value; ";
            }
            edit($m, $at, $end - $at, $text);
        }
    }
    for my $below (map { $module{$_} } sort grep { !exists $box{$_} && $flat =~ /\b\Q$_\E\b/ } keys %module) {
        next if $below == $m;
        open_module($below);
        next if !@{$below->{opened}};
        for my $instance (instances($below->{name}, $flat)) {
            my ($name, $pins, undef, undef, $last) = @$instance;
            my @more;
            for my $port (@{$below->{opened}}) {
                my ($inner, $way, $range) = @$port;
                fail("$below->{name} $name: how wide $inner is follows its parameters") if $range =~ /[A-Za-z_`]/;
                push @new, ["$name\$$inner", $way, $range];
                push @more, ".$inner($name\$$inner)";
            }
            edit($m, $last, 0, (@$pins ? ', ' : '') . join ', ', @more);
        }
    }
    return if !@new;
    my @names = map { $_->[0] } @new;
    my @texts = map { "$_->[1] wire$_->[2] $_->[0]" } @new;
    fail("$m->{name}: has no port") if !@items;
    edit($m, $m->{list_end}, 0, ', ' . join ', ', $is_ansi ? @texts : @names);
    edit($m, $head, 0, ' ' . join ' ', map { "$_;" } @texts) if !$is_ansi;
    $m->{opened} = \@new;
    return;
}
fail("no file has the module $top") if !$module{$top};
open_module($module{$top});
for my $name (sort grep { !$box{$_} } keys %box) { fail("$name: a blackbox that $top has no instance of") }
write_files($folder, @files);
