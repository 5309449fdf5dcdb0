package org.dfra.core.audit;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.dfra.core.audit.AuditLine.Header;
import org.dfra.core.audit.VerifiedStream.Break;
import org.dfra.core.audit.VerifiedStream.Kind;
import org.jspecify.annotations.Nullable;

/** Verifies one stream, with three lines in memory. */
final class StreamVerifier {

  private final String stream;
  private final List<TrailFile> files;
  private final List<KeptHead> heads;
  private final List<String> notes = new ArrayList<>();

  private long lines;
  private long first;
  private long torn;

  /** Files below this one were removed when a later one began. */
  private long oldestKept = 1;

  private @Nullable ChainLine last;

  /**
   * @param heads of this stream, each signed
   */
  StreamVerifier(String stream, List<TrailFile> files, List<KeptHead> heads) {
    this.stream = stream;
    this.files = files;
    this.heads = heads;
  }

  VerifiedStream verify() throws IOException {
    Optional<Break> broken = readAll();
    if (broken.isEmpty()) {
      broken = removed().or(this::cut);
    }
    if (torn > 0) {
      notes.add(
          torn
              + (torn == 1 ? " torn line was" : " torn lines were")
              + " moved to files .torn beside the trail, after crashes");
    }
    long end = last == null || last.line() == null ? 0 : last.line().number();
    return new VerifiedStream(stream, files.size(), lines, first, end, broken, notes);
  }

  private Optional<Break> readAll() throws IOException {
    try (ChainLines source = new ChainLines(files)) {
      @Nullable ChainLine current = source.next();
      @Nullable ChainLine after = current == null ? null : source.next();
      while (current != null) {
        Optional<Break> broken = ChainCheck.check(last, current, after);
        if (broken.isEmpty() && current.line() != null) {
          broken = againstHeads(current, current.line());
        }
        if (broken.isPresent()) {
          return broken;
        }
        accept(current);
        current = after;
        after = current == null ? null : source.next();
      }
    }
    return Optional.empty();
  }

  private void accept(ChainLine good) {
    AuditLine line = good.line();
    if (line != null) {
      lines++;
      first = first == 0 ? line.number() : first;
      torn += line.is(AuditKind.TORN_LINE) ? 1 : 0;
      Optional<Header> header = line.header();
      header.ifPresent(each -> oldestKept = Math.max(oldestKept, each.file() - each.files() + 1));
    }
    last = good;
  }

  private Optional<Break> againstHeads(ChainLine current, AuditLine line) {
    @Nullable KeptHead other = null;
    @Nullable KeptHead same = null;
    for (KeptHead each : heads) {
      if (each.head().number() == line.number()) {
        boolean isSame = each.head().hash().equals(current.hash());
        same = isSame ? each : same;
        other = isSame ? other : each;
      }
    }
    if (other == null) {
      return Optional.empty();
    }
    return Optional.of(
        same == null
            ? current.broken(
                Kind.CHANGED,
                "this line, or one before it, was changed: " + signed(other) + " another one")
            : current.broken(
                Kind.FORKED,
                "the trail was written twice: "
                    + signed(same)
                    + " this line, and at "
                    + LineEncoder.time(other.head().time())
                    + " another one with this number"));
  }

  /** Older files may only be missing if a later one removed them. */
  private Optional<Break> removed() {
    if (files.isEmpty() || files.get(0).number() <= oldestKept) {
      return Optional.empty();
    }
    TrailFile oldest = files.get(0);
    return Optional.of(
        new Break(
            oldest.path(),
            1,
            Kind.MISSING,
            "files "
                + oldestKept
                + " to "
                + (oldest.number() - 1)
                + " of the stream are missing, which no later file has replaced"));
  }

  private Optional<Break> cut() {
    long end = last == null || last.line() == null ? 0 : last.line().number();
    Optional<KeptHead> newest =
        heads.stream().max(Comparator.comparingLong(each -> each.head().number()));
    if (newest.isPresent() && newest.get().head().number() > end) {
      Path file = last == null ? Path.of(stream) : last.path();
      String sentence =
          end == 0
              ? "the stream was removed: " + signed(newest.get())
              : "the stream was cut after line " + end + ": " + signed(newest.get());
      return Optional.of(new Break(file, last == null ? 1 : last.at(), Kind.CUT, sentence));
    }
    if (newest.isPresent() && newest.get().head().number() < first) {
      notes.add(
          "the head with number "
              + newest.get().head().number()
              + " is older than the first line that is left, "
              + first
              + ", and proves nothing now");
    }
    return Optional.empty();
  }

  private static String signed(KeptHead kept) {
    return kept.member()
        + " signed number "
        + kept.head().number()
        + " at "
        + LineEncoder.time(kept.head().time());
  }
}
