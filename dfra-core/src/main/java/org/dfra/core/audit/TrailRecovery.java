package org.dfra.core.audit;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import org.dfra.core.audit.LineReader.RawLine;
import org.dfra.core.host.PrivateFiles;
import org.jspecify.annotations.Nullable;

/**
 * Finds the end of a stream's chain when its process starts. What follows the last line that can be
 * read was torn by a crash: it is moved to a file beside the trail.
 *
 * @param position the end of the chain
 * @param file number of the file to continue; 0 if there is none
 * @param size of that file, bytes; 0 if its first line is missing
 * @param torn what was moved, in sentences
 */
record TrailRecovery(TrailPosition position, long file, long size, List<String> torn) {

  /** Finds the end of a stream's chain; only for the process that holds the stream's lock. */
  static TrailRecovery recover(Path folder, String stream) throws IOException {
    List<TrailFile> files = TrailFile.in(folder, stream);
    if (files.isEmpty()) {
      return new TrailRecovery(TrailPosition.START, 0, 0, List.of());
    }
    List<String> torn = new ArrayList<>();
    long last = files.get(files.size() - 1).number();
    long size = 0;
    @Nullable TrailPosition position = null;
    for (int i = files.size() - 1; i >= 0 && position == null; i--) {
      TrailFile file = files.get(i);
      Tail tail = Tail.of(file.path());
      moveTorn(file, tail.end(), torn);
      position = tail.position();
      size = file.number() == last ? tail.end() : size;
    }
    return new TrailRecovery(
        position == null ? TrailPosition.START : position, last, size, List.copyOf(torn));
  }

  /**
   * The last line of a file that can be read.
   *
   * @param position null if there is none
   * @param end offset after it
   */
  private record Tail(@Nullable TrailPosition position, long end) {

    /** Decodes from the end: nearly always only the last line, since a start must be fast. */
    static Tail of(Path path) throws IOException {
      List<Long> begins = begins(path);
      for (int i = begins.size() - 1; i >= 0; i--) {
        try (LineReader lines = LineReader.open(path, begins.get(i))) {
          @Nullable RawLine line = lines.next();
          @Nullable TrailPosition at = line == null ? null : position(line);
          if (line != null && at != null) {
            return new Tail(at, line.end());
          }
        }
      }
      return new Tail(null, 0);
    }

    private static List<Long> begins(Path path) throws IOException {
      List<Long> begins = new ArrayList<>();
      try (LineReader lines = LineReader.open(path, 0)) {
        long begin = 0;
        for (@Nullable RawLine line = lines.next(); line != null; line = lines.next()) {
          begins.add(begin);
          begin = line.end();
        }
      }
      return begins;
    }

    private static @Nullable TrailPosition position(RawLine line) {
      if (!line.isComplete() || line.isTooLong()) {
        return null;
      }
      try {
        long number = LineDecoder.decode(line.bytes()).number();
        return new TrailPosition(number, TrailPosition.hash(line.bytes()));
      } catch (IOException e) {
        return null; // if it is before a good line, the verifier reports it
      }
    }
  }

  private static void moveTorn(TrailFile file, long end, List<String> torn) throws IOException {
    long bytes = Files.size(file.path()) - end;
    if (bytes == 0) {
      return;
    }
    Path beside = beside(file.path());
    try (InputStream in = Files.newInputStream(file.path());
        FileChannel to =
            FileChannel.open(
                beside,
                EnumSet.of(StandardOpenOption.CREATE, StandardOpenOption.APPEND),
                PrivateFiles.privateFile());
        OutputStream out = Channels.newOutputStream(to)) {
      in.skipNBytes(end);
      long unused = in.transferTo(out);
      to.force(true);
    }
    try (FileChannel channel = FileChannel.open(file.path(), StandardOpenOption.WRITE)) {
      FileChannel unused = channel.truncate(end);
      channel.force(true);
    }
    torn.add(
        bytes
            + " bytes after the last whole line of "
            + file.path().getFileName()
            + " are now at the end of "
            + beside.getFileName());
  }

  /** The file for what was torn from a file of the trail. */
  static Path beside(Path file) {
    return file.resolveSibling(file.getFileName() + ".torn");
  }
}
