# perl inout.pl TOP FOLDER FILE...
#
# Verilog whose inout ports are split. A port `pad` that is driven `en ? value : 'z` becomes three: pad$in,
# what comes from outside; pad$out and pad$en, what goes out and which bits do. Within the module the net
# `pad` is what stands on the wire: what is driven, and else what comes in. An inout port that nothing
# drives becomes an input. So it is with the modules that TOP needs; files without such a port stay as they
# are, the others are written into FOLDER, line by line where they were. On stdout the files to read, one a
# line; on stderr one line where a port cannot be split.
#
# What drives is an assignment, bufif0, bufif1, or a module whose port is split in its turn.
use strict;
use warnings;
use FindBin;
require "$FindBin::Bin/verilog_text.pl";

our ($group, $select, %words, %module);
my ($top, $folder, @files) = @ARGV;
my %done;
read_modules(@files);

sub place { return "$_[0]{name}: $_[1]" }

# What stands at a number of bits that are all z.
sub is_z { return $_[0] =~ /^[\s({]*(?:[\w\s\$+*\/()-]*\{)?\s*\d*\s*'\s*(?:[sS]?[bohdBOHD]\s*)?[zZ?][zZ?_]*[\s)}]*$/ }
sub unwrapped {
    my ($e) = @_;
    $e =~ s/^\s+|\s+$//g;
    $e =~ s/^\((.*)\)$/$1/s && $e =~ s/^\s+|\s+$//g while $e =~ /^$group$/;
    return $e;
}
# (C, A, B) of C ? A : B; nothing of another expression.
sub choice {
    my ($e) = @_;
    my ($depth, $marks, $mark, $colon) = (0, 0);
    for my $i (0 .. length($e) - 1) {
        my $c = substr $e, $i, 1;
        ++$depth if $c =~ /[(\[{]/;
        --$depth if $c =~ /[)\]}]/;
        next if $depth;
        if ($c eq '?') { $mark //= $i; ++$marks }
        if ($c eq ':' && defined $mark && !--$marks) { $colon = $i; last }
    }
    return if !defined $colon;
    return (substr($e, 0, $mark), substr($e, $mark + 1, $colon - $mark - 1), substr($e, $colon + 1));
}
# Which bits an expression drives, and with what.
sub driven {
    my ($m, $e, $target) = @_;
    $e = unwrapped($e);
    return ("1'b0", "1'b0") if is_z($e);
    if (my ($if, @ways) = choice($e)) {
        my ($then, $else) = map { [driven($m, $_, $target)] } @ways;
        return map { "(($if) ? $then->[$_] : $else->[$_])" } 0, 1;
    }
    my ($named) = $e =~ /^\w+$/ ? $m->{body} =~ /\b(?:assign|wire\b[^;=]*?)\s*\b\Q$e\E\s*=([^;]*);/ : ();
    return driven($m, $named, $target) if defined $named && $named =~ /'\s*\w?[zZ]/;
    fail(place($m, $target) . ": an inout port that is driven by '$e', which may be z")
      if $e =~ /'\s*\w?[zZ]/
      || $e =~ /^\w+$/ && $m->{body} =~ /\b\Q$e\E$select\s*<?=[^;=]*'\s*[bohdBOHD]?[zZ]/;
    return ("~1'b0", "($e)");
}

# A driver of a net, in place of the text at `at`; `by` writes it for the nets of what is driven and which bits.
sub drive {
    my ($m, $net, $part, $at, $length, $by) = @_;
    push @{$m->{drivers}{$net}}, {part => $part, at => $at, length => $length, by => $by};
    return;
}

# Looks for all that drives the inout ports of a module, those it has instances of first.
sub split_module {
    my ($m) = @_;
    return if $done{$m->{name}}++;
    my ($body, $flat, $head, $is_ansi, @items) = ($m->{body}, head_of($m));
    my %port;       # an inout port => its range
    my ($way, $range) = ('', '');
    for my $item ($is_ansi ? @items : ()) {
        my ($text) = @$item;
        ($way, $range) = ($1, '') if $text =~ s/^(input|output|inout)\b//;
        next if $way ne 'inout';
        $range = $1 if $text =~ s/^(?:\s*(?:wire|logic|tri[01]?|signed))*((?:\s*\[[^\]]*\])*)\s*(?=\w+\s*(?:\[|$))// && $1 ne '';
        fail(place($m, $text) . ": an inout port that is an array") if $text !~ /^\s*(\w+)$/;
        $port{$1} = {range => $range, item => $item};
    }
    if (!$is_ansi) {
        while ($flat =~ /\binout\b(?:\s*(?:wire|tri[01]?|signed)\b)*((?:\s*\[[^\]]*\])*)([^;]*);/g) {
            my ($r, $names, $at, $length) = ($1, $2, $-[0], $+[0] - $-[0]);
            for my $name (map { $_->[0] } parts($names, 0)) {
                my ($item) = grep { $_->[0] eq $name } @items;
                fail(place($m, $name) . ": an inout port that is not in the list of ports") if !$item;
                $port{$name} = {range => $r, item => $item, at => $at, length => $length};
            }
        }
    }
    my %is_inout = map { $_ => 1 } keys %port;

    while ($flat =~ /\bassign\b\s*(?:\([^()]*\)\s*)?(?:#\s*(?:\d+|$group)\s*)?([^;]*);/g) {
        my ($at, $length, @all) = ($-[0], $+[0] - $-[0], parts($2, $-[2]));
        my @kept;
        my $written = '';
        for my $one (@all) {
            my ($target, $e) = $one->[0] =~ /^(.*?)\s*=(?!=)(.*)$/s or next;
            my ($net, $part) = $target =~ /^(\w+)($select)$/;
            if (!defined $net || !$is_inout{$net}) {
                my ($in) = grep { $is_inout{$_} } $target =~ /^\s*\{/ ? $target =~ /(\w+)/g : ();
                fail(place($m, $in) . ": an inout port that is driven in a part of { }") if defined $in;
                push @kept, original($m, $one->[1], length $one->[0]);
                next;
            }
            my ($which, $what) = driven($m, $e, $net);
            drive($m, $net, $part, $at, 0,
                sub { "assign $_[1]$part = $which; assign $_[0]$part = $what; " });
            $written = 1;
        }
        next if !$written;
        edit($m, $at, $length, @kept ? 'assign ' . join(', ', @kept) . ';' : '');
    }
    while ($flat =~ /\b(buf|not)if([01])\b\s*(?:#\s*(?:\d+|$group)\s*)?\w*\s*$group\s*;/g) {
        my ($how, $level, $at, $length, $pins) = ($1, $2, $-[0], $+[0] - $-[0], $4);
        my ($pin, $data, $control) = map { $_->[0] } parts($pins =~ s/^\(|\)$//gr, 0);
        my ($net, $part) = ($pin // '') =~ /^(\w+)($select)$/ or next;
        next if !$is_inout{$net};
        my ($value, $if) = (($how eq 'not' ? '~' : '') . "($data)", ($level ? '' : '!') . "($control)");
        drive($m, $net, $part, $at, 0,
            sub { "assign $_[1]$part = $if ? ~1'b0 : 1'b0; assign $_[0]$part = $if ? $value : 1'b0; " });
        edit($m, $at, $length, '');
    }
    for my $name (sort keys %module) {
        my $inner = $module{$name};
        next if $flat !~ /\b\Q$name\E\b/ || $name eq $m->{name};
        split_module($inner);
        next if !grep { $_->{is_split} } values %{$inner->{ports}};
        while ($flat =~ /\b\Q$name\E\b\s*(?:#\s*$group)?\s*(\w+)\s*(\[[^\]]*\])?\s*$group\s*;/g) {
            my ($instance, $many, $pins, $pins_at) = ($2, $3, $4, $-[4]);
            my @pins = parts($pins =~ s/^\(|\)$//gr, $pins_at + 1);
            for my $port (sort grep { $inner->{ports}{$_}{is_split} } keys %{$inner->{ports}}) {
                fail("$m->{name}.$instance: instances with an inout port, $port, as an array") if defined $many;
                fail("$m->{name}.$instance: its pins are given in their order, and $port is an inout port")
                  if @pins && $pins[0][0] !~ /^\./;
                my ($pin) = grep { $_->[0] =~ /^\.\s*\Q$port\E\s*\(/ } @pins or next;
                my ($e) = $pin->[0] =~ /^\.\s*\w+\s*\((.*)\)$/s;
                $e =~ s/^\s+|\s+$//g;
                my ($net, $part) = $e =~ /^(\w+)($select)$/;
                if ($e ne '' && (!defined $net || !$is_inout{$net})) {
                    fail("$m->{name}.$instance: its inout port $port is joined to '$e', no inout port of $m->{name}");
                }
                my $length = length $pin->[0];
                if ($e eq '') {
                    edit($m, $pin->[1], $length, ".$port\$in(1'b0), .$port\$out(), .$port\$en()");
                    next;
                }
                drive($m, $net, $part, $pin->[1], $length,
                    sub { ".$port\$in($e), .$port\$out($_[0]$part), .$port\$en($_[1]$part)" });
            }
        }
    }
    my $more = '';
    my %declared;    # place of a declaration => what stands there now
    for my $net (sort keys %port) {
        my $p = $port{$net};
        my @drivers = @{$m->{drivers}{$net} // []};
        $p->{is_split} = @drivers > 0;
        if (!@drivers) {
            edit($m, $p->{item}[1], length $p->{item}[0], "input wire$p->{range} $net") if $is_ansi;
            $declared{$p->{at}} .= "input$p->{range} $net;" if !$is_ansi;
            next;
        }
        # Several of them, a wire each; where they drive parts, each its own.
        my $is_parted = !grep { $_->{part} eq '' } @drivers;
        my %parts = map { $_->{part} => 1 } @drivers;
        fail(place($m, $net) . ": an inout port that is driven more than once, in part")
          if @drivers > 1 && ($is_parted ? keys %parts < @drivers : keys %parts > 1);
        my ($text, @out, @en) = '';
        for my $i (0 .. $#drivers) {
            my ($out, $en) = ("$net\$out", "$net\$en");
            if (@drivers > 1 && !$is_parted) {
                ($out, $en) = ("$net\$out$i", "$net\$en$i");
                $text .= "wire$p->{range} $out, $en; ";
                push @out, "$out & $en";
                push @en, $en;
            }
            edit($m, @{$drivers[$i]}{qw(at length)}, $drivers[$i]{by}->($out, $en));
        }
        if (@en) {
            $text .= "assign $net\$out = " . join(' | ', map { "($_)" } @out) . '; ';
            $text .= "assign $net\$en = " . join(' | ', @en) . '; ';
        }
        my $has_net = $flat =~ /\b(?:wire|tri[01]?)\b[^;=]*\b\Q$net\E\b\s*[,;]/ && !$is_ansi;
        $text = "wire$p->{range} $net; $text" if !$has_net;
        my $stands = "assign $net = ($net\$en & $net\$out) | (~$net\$en & $net\$in);";
        if ($has_net) { edit($m, length $body, 0, " $stands ") } else { $text .= $stands }
        if ($is_ansi) {
            edit($m, $p->{item}[1], length $p->{item}[0],
                "input wire$p->{range} $net\$in, output wire$p->{range} $net\$out, output wire$p->{range} $net\$en");
            $more .= " $text";
        } else {
            edit($m, $p->{item}[1], length $p->{item}[0], "$net\$in, $net\$out, $net\$en");
            $declared{$p->{at}} .= "input$p->{range} $net\$in; output$p->{range} $net\$out, $net\$en; $text";
        }
    }
    edit($m, $head, 0, $more) if $more ne '';
    my %length = map { $_->{at} => $_->{length} } grep { defined $_->{at} } values %port;
    edit($m, $_, $length{$_}, $declared{$_}) for sort keys %declared;
    $m->{ports} = \%port;
    return;
}
split_module($module{$top}) if $module{$top} && grep { /\binout\b/ } values %words;
write_files($folder, @files);
