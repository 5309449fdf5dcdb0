package org.dfra.river.bootstrap;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** DFRA's own jars for clients that lack its classes. */
final class DownloadJars {

  /** System property with the folder of DFRA's jars; {@code ./dfra} sets it. */
  private static final String LIB = "dfra.lib";

  private DownloadJars() {}

  /**
   * The jars in the folder {@code dl} of DFRA's own, sorted by name; none where DFRA is a part of
   * another program, which has no such folder.
   *
   * @throws IOException if they are not where they should be
   */
  static List<Path> ofDfra() throws IOException {
    return in(System.getProperty(LIB));
  }

  static List<Path> in(@Nullable String lib) throws IOException {
    if (lib == null) {
      return List.of();
    }
    Path folder = Path.of(lib).toAbsolutePath().resolve("dl");
    List<Path> jars = List.of();
    if (Files.isDirectory(folder)) {
      try (Stream<Path> files = Files.list(folder)) {
        jars = files.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
      }
    }
    if (jars.isEmpty()) {
      throw new IOException(
          "there is no jar for clients to download in "
              + folder
              + "; build DFRA anew, or write classes=\"off\" in <registrar>");
    }
    return jars;
  }
}
