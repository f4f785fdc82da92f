# What inout.pl and blackbox.pl have in common: the modules of Verilog as words, and edits of their text.
#
# No grammar is read: comments and texts are blanked out, places stay, and edits are made from the end.
use strict;
use warnings;
use Cwd qw(abs_path);
use File::Basename qw(basename dirname);

our $group = qr/(\((?:[^()]++|(?-1))*\))/;           # one pair of parentheses, and what is in it
our $select = qr/(?:\s*\[[^\]]*\])*/;
our (%words, %module);    # file => its words; name => {name, file, at, body}
my (%text, %edits);

sub fail { print STDERR "$_[0]\n"; exit 1 }
sub text_of {
    open my $in, '<:raw', $_[0] or fail("$_[0]: no such file");
    return do { local $/; <$in> } // '';
}

sub read_modules {
    for my $file (@_) {
        my $text = $text{$file} = text_of($file);
        my $blank = sub { $_[0] =~ s/[^\n]/ /gr };
        $text =~ s{(//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"|\(\*[^)].*?\*\))}{$blank->($1)}gse;
        $text =~ s{^([ \t]*`(?:ifn?def|els\w+|endif|define|undef|include|timescale|default_nettype|resetall)[^\n]*)}{$blank->($1)}gme;
        $words{$file} = $text;
        while ($text =~ /\bmodule\s+(?:automatic\s+|static\s+)?(\w+)(.*?)\bendmodule\b/gs) {
            $module{$1} //= {name => $1, file => $file, at => $-[2], body => $2};
        }
    }
    return;
}
sub edit {
    my ($m, $at, $length, $by) = @_;
    # As many lines as before.
    $by .= "\n" x (substr($m->{body}, $at, $length) =~ tr/\n//);
    push @{$edits{$m->{file}}}, [$m->{at} + $at, $length, $by];
    return;
}
# The parts of a list, [text, where it begins], without the blanks around them.
sub parts {
    my ($list, $at) = @_;
    my @parts;
    my ($depth, $from) = (0, 0);
    my $plain = $list =~ s{("(?:[^"\\\n]|\\.)*")}{'"' x length $1}gre;    # nothing in a text ends a part
    for my $i (0 .. length $list) {
        my $c = $i < length $list ? substr $plain, $i, 1 : ',';
        ++$depth if $c =~ /[(\[{]/;
        --$depth if $c =~ /[)\]}]/;
        next if $c ne ',' || $depth;
        my $part = substr $list, $from, $i - $from;
        my $blanks = $part =~ /^(\s*)/ ? length $1 : 0;
        push @parts, [$part =~ s/^\s+|\s+$//gr, $at + $from + $blanks] if $part =~ /\S/;
        $from = $i + 1;
    }
    return @parts;
}
# Of a module: its body without tasks and functions; where its head ends; whether that has the ways of the
# ports in it, and the list of them.
sub head_of {
    my ($m) = @_;
    (my $flat = $m->{body}) =~ s{(\b(?:task|function)\b.*?\bend(?:task|function)\b)}{$1 =~ s/[^\n]/ /gr}gse;
    fail("$m->{name}: its ports cannot be told")
      if $flat !~ /^(?:\s*import\b[^;]*;)*(?:\s*#\s*$group)?\s*(?:$group)?\s*;/;
    my ($head, $list, $list_at) = ($+[0], $2 // '', $-[2] // 0);
    $m->{list_end} = $list_at + length($list) - 1;
    my @items = parts($list =~ s/^\(|\)$//gr, $list_at + 1);
    return ($flat, $head, $list =~ /\b(?:input|output|inout)\b/ ? 1 : 0, @items);
}
sub without_comments { return $_[0] =~ s{("(?:[^"\\\n]|\\.)*")|//[^\n]*|/\*.*?\*/}{$1 // ' '}gser }
sub original { my ($m, $at, $length) = @_; return substr $text{$m->{file}}, $m->{at} + $at, $length }
# Writes the files that edits were made in into a folder; on stdout all files to read, one a line.
sub write_files {
    my ($folder, @files) = @_;
    my %written;
    for my $file (@files) {
        my $made = $file;
        if (my $edits = $edits{$file}) {
            my $text = $text{$file};
            # Of two at one place the one that takes text away is behind.
            for my $edit (sort { $b->[0] <=> $a->[0] || $b->[1] <=> $a->[1] } @$edits) {
                substr($text, $edit->[0], $edit->[1]) = $edit->[2];
            }
            my $home = dirname(abs_path($file));
            $text =~ s{(`include\s+")([^"/][^"]*)"}{-e "$home/$2" ? "$1$home/$2\"" : "$1$2\""}ge;
            mkdir $folder;
            $made = "$folder/" . basename($file);
            $made = "$folder/" . keys(%written) . basename($file) if $written{$made};
            $written{$made} = 1;
            open my $out, '>:raw', $made or fail("cannot write: $made");
            # What is said of a line names the file that the user has.
            print {$out} ($file =~ /"/ ? '' : "`line 1 \"$file\" 0\n"), $text;
            close $out or fail("cannot write: $made");
        }
        print "$made\n";
    }
    return;
}

1;
