package org.dfra.core.audit;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.dfra.core.audit.LineReader.RawLine;
import org.jspecify.annotations.Nullable;

/**
 * Reads the lines of all streams of a folder, also while they are written. It does not verify them.
 * Confined to one thread.
 */
public final class TrailReader {

  /**
   * A line.
   *
   * @param stream to which it belongs
   * @param place file and line, as {@code FILE:LINE}
   * @param line empty if it cannot be read
   */
  public record Read(String stream, String place, Optional<AuditLine> line) {}

  /** Where the reading of a stream goes on. */
  private record Place(long file, long offset, long lines) {}

  private final Path folder;
  private final Map<String, Place> places = new HashMap<>();

  /**
   * @param folder of the trail, which may be missing
   */
  public TrailReader(Path folder) {
    this.folder = folder;
  }

  /**
   * Reads the lines that have been completed since the last call; at the first call, all. Those of
   * a stream come in order, stream after stream.
   *
   * @throws IOException if a file cannot be read
   */
  public void read(Consumer<Read> to) throws IOException {
    for (Map.Entry<String, List<TrailFile>> each : TrailFile.in(folder).entrySet()) {
      for (TrailFile file : each.getValue()) {
        Place known = places.getOrDefault(each.getKey(), new Place(0, 0, 0));
        if (file.number() >= known.file()) {
          boolean isSame = file.number() == known.file();
          Place begin = isSame ? known : new Place(file.number(), 0, 0);
          places.put(each.getKey(), read(file, begin, to));
        }
      }
    }
  }

  private static Place read(TrailFile file, Place begin, Consumer<Read> to) throws IOException {
    long offset = begin.offset();
    long number = begin.lines();
    try (LineReader lines = LineReader.open(file.path(), offset)) {
      for (@Nullable RawLine raw = lines.next(); raw != null; raw = lines.next()) {
        if (!raw.isComplete()) {
          break; // read again when it is
        }
        number++;
        offset = raw.end();
        to.accept(new Read(file.stream(), file.path() + ":" + number, decode(raw)));
      }
    } catch (NoSuchFileException e) {
      return begin; // its writer has just removed it, since newer files replace it
    }
    return new Place(file.number(), offset, number);
  }

  private static Optional<AuditLine> decode(RawLine raw) {
    if (raw.isTooLong()) {
      return Optional.empty();
    }
    try {
      return Optional.of(LineDecoder.decode(raw.bytes()));
    } catch (IOException e) {
      return Optional.empty(); // reported by its place
    }
  }
}
