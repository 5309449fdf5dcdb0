package org.dfra.core.audit;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A file of a stream, {@code STREAM.NUMBER.jsonl}.
 *
 * @param number 1 for the first file that the stream ever had
 */
record TrailFile(String stream, long number, Path path) {

  private static final Pattern NAME =
      Pattern.compile("(" + AuditSettings.STREAM + ")\\.(\\d{6,18})\\.jsonl");

  static TrailFile of(Path folder, String stream, long number) {
    String name = String.format(Locale.ROOT, "%s.%06d.jsonl", stream, number);
    return new TrailFile(stream, number, folder.resolve(name));
  }

  private static Optional<TrailFile> parse(Path path) {
    Matcher name = NAME.matcher(String.valueOf(path.getFileName()));
    return name.matches()
        ? Optional.of(new TrailFile(name.group(1), Long.parseLong(name.group(2)), path))
        : Optional.empty();
  }

  /** The files of each stream, in order of their numbers; none if the folder does not exist. */
  static SortedMap<String, List<TrailFile>> in(Path folder) throws IOException {
    SortedMap<String, List<TrailFile>> streams = new TreeMap<>();
    try (Stream<Path> all = Files.list(folder)) {
      all.map(TrailFile::parse)
          .flatMap(Optional::stream)
          .sorted(Comparator.comparingLong(TrailFile::number))
          .forEach(
              each -> streams.computeIfAbsent(each.stream, key -> new ArrayList<>()).add(each));
    } catch (NoSuchFileException e) {
      return streams;
    } catch (NotDirectoryException e) {
      throw new IOException(folder + " is a file; the audit trail is in a folder", e);
    } catch (AccessDeniedException e) {
      throw LineReader.notReadable(folder, e);
    }
    return streams;
  }

  /** The files of one stream. */
  static List<TrailFile> in(Path folder, String stream) throws IOException {
    return in(folder).getOrDefault(stream, List.of());
  }
}
