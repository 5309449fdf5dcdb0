package org.dfra.build;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The files of this checkout. */
final class Repository {

  private Repository() {}

  /** Its top directory, as the build tells the tests. */
  static Path root() {
    String root = System.getProperty("dfra.root");
    if (root == null) {
      throw new IllegalStateException(
          "system property dfra.root is not set; run the tests through ./dfra test, Maven or Gradle, or set it to"
              + " the top directory of the checkout");
    }
    return Path.of(root);
  }

  static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The directories {@code dfra-*} below {@code root} that hold a {@code file}, by name. */
  static List<Path> modulesWith(Path root, String file) {
    try (Stream<Path> entries = Files.list(root)) {
      return entries
          .filter(entry -> entry.getFileName().toString().startsWith("dfra-"))
          .filter(entry -> Files.exists(entry.resolve(file)))
          .sorted()
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Every directory of Java sources below a module's {@code src/main/java}. */
  static List<Path> mainPackages(Path root) {
    return modulesWith(root, "src/main/java").stream()
        .flatMap(module -> packagesBelow(module.resolve("src/main/java")))
        .toList();
  }

  /** The folders with sources of tests, each a package. */
  static List<Path> testPackages(Path root) {
    return Stream.concat(Stream.of(root), modulesWith(root, "src/test/java").stream())
        .flatMap(module -> packagesBelow(module.resolve("src/test/java")))
        .toList();
  }

  private static Stream<Path> packagesBelow(Path sources) {
    try (Stream<Path> files = Files.walk(sources)) {
      return files
          .filter(file -> file.toString().endsWith(".java"))
          .map(Path::getParent)
          .distinct()
          .sorted()
          .toList()
          .stream();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
