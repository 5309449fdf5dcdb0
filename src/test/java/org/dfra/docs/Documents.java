package org.dfra.docs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The documents of this checkout, and what they name. */
final class Documents {

  /** The checkout's top directory, as the build tells the tests. */
  static final Path ROOT =
      Path.of(Objects.requireNonNull(System.getProperty("dfra.root"), "dfra.root is not set"));

  private static final Pattern FENCE = Pattern.compile("(?ms)^```[^\\n]*\\n(.*?)^```$");
  private static final Pattern INDENTED = Pattern.compile("(?m)(?<=^\\n)(?: {4}.*\\n)+");
  private static final Pattern INLINE = Pattern.compile("`([^`\\n]+)`");

  private Documents() {}

  /** One document. */
  record Document(Path file, String text) {

    /** Relative to the checkout, for messages. */
    String name() {
      return ROOT.relativize(file).toString();
    }

    /** The text without blocks of code, where a link would be no link. */
    String prose() {
      return INDENTED.matcher(FENCE.matcher(text).replaceAll("")).replaceAll("");
    }

    /** Every piece of code: each line of a block, and what stands between backticks. */
    List<String> code() {
      List<String> code = new ArrayList<>();
      FENCE.matcher(text).results().forEach(found -> found.group(1).lines().forEach(code::add));
      INDENTED
          .matcher(FENCE.matcher(text).replaceAll(""))
          .results()
          .forEach(found -> found.group().lines().map(String::strip).forEach(code::add));
      INLINE.matcher(prose()).results().forEach(found -> code.add(found.group(1)));
      return code;
    }

    /** The anchors of its headings, as a repository's pages make them. */
    List<String> anchors() {
      Map<String, Integer> seen = new HashMap<>();
      return FENCE
          .matcher(text)
          .replaceAll("")
          .lines()
          .filter(line -> line.matches("#{1,6} .*"))
          .map(line -> anchor(line.replaceFirst("^#+ ", "")))
          .map(
              anchor -> {
                int before = seen.merge(anchor, 1, Integer::sum) - 1;
                return before == 0 ? anchor : anchor + "-" + before;
              })
          .toList();
    }

    private static String anchor(String heading) {
      return heading
          .strip()
          .toLowerCase(Locale.ROOT)
          .replaceAll("[^\\p{L}\\p{N} _-]", "")
          .replace(' ', '-');
    }
  }

  /** Every document that users read. */
  static List<Document> all() {
    List<Path> files = new ArrayList<>();
    try (Stream<Path> top = Files.list(ROOT);
        Stream<Path> docs = Files.walk(ROOT.resolve("docs"));
        Stream<Path> benchmarks = Files.walk(ROOT.resolve("benchmarks"))) {
      Stream.of(top, docs, benchmarks)
          .flatMap(each -> each)
          .filter(file -> file.toString().endsWith(".md"))
          .sorted()
          .forEach(files::add);
      return files.stream().map(file -> new Document(file, read(file))).toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** One document by its path from the top. */
  static Document of(String path) {
    Path file = ROOT.resolve(path);
    return new Document(file, read(file));
  }

  static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
