package org.dfra.activation;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What javap shows of a class to others: its header and its public and protected members. */
final class ApiListing {

  private static final String PACKAGE = "java/rmi/activation";

  private ApiListing() {}

  /**
   * The lines of one class file: type parameters, modifiers, throws and constant values in them.
   */
  static Set<String> of(Path classFile) {
    return run("javap", "-protected", "-constants", classFile.toString())
        .lines()
        .filter(line -> !line.startsWith("Compiled from"))
        .map(String::strip)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Lines only in the first (with -) or only in the second (with +). */
  static List<String> difference(Path wanted, Path found) {
    Set<String> missing = of(wanted);
    Set<String> extra = of(found);
    Set<String> common = new TreeSet<>(missing);
    common.retainAll(extra);
    missing.removeAll(common);
    extra.removeAll(common);
    List<String> lines = new ArrayList<>();
    missing.forEach(line -> lines.add("- " + line));
    extra.forEach(line -> lines.add("+ " + line));
    return lines;
  }

  /** Whether others see the class at all. */
  static boolean isPublic(Path classFile) {
    return of(classFile).stream()
        .anyMatch(line -> line.startsWith("public ") && line.endsWith("{"));
  }

  /** The class files of java.rmi.activation that this JDK keeps of release 16, by file name. */
  static Map<String, Path> ofRelease16(Path folder) throws IOException {
    Path symbols = Path.of(System.getProperty("java.home"), "lib", "ct.sym");
    Map<String, Path> files = new TreeMap<>();
    // A folder is named by the releases whose classes it holds, one digit or letter each.
    try (FileSystem zip = FileSystems.newFileSystem(symbols, Map.of("accessMode", "readOnly"));
        Stream<Path> releases = Files.list(zip.getPath("/"))) {
      for (Path release : releases.filter(p -> p.getFileName().toString().contains("G")).toList()) {
        Path api = release.resolve("java.rmi").resolve(PACKAGE);
        if (Files.isDirectory(api)) {
          try (Stream<Path> entries = Files.list(api)) {
            for (Path entry : entries.toList()) {
              String name = entry.getFileName().toString().replace(".sig", ".class");
              files.put(name, Files.write(folder.resolve(name), Files.readAllBytes(entry)));
            }
          }
        }
      }
    }
    return files;
  }

  /** This module's own class files of the package, by file name. */
  static Map<String, Path> ofThisModule() throws IOException {
    try (Stream<Path> files =
        Files.list(Path.of(System.getProperty("dfra.boot-class-path"), PACKAGE))) {
      return files.collect(
          Collectors.toMap(p -> p.getFileName().toString(), p -> p, (a, b) -> a, TreeMap::new));
    }
  }

  /** Runs a tool of the JDK and returns what it printed. */
  static String run(String tool, String... args) {
    StringWriter printed = new StringWriter();
    PrintWriter out = new PrintWriter(printed);
    int code = ToolProvider.findFirst(tool).orElseThrow().run(out, out, args);
    out.flush();
    if (code != 0) {
      throw new AssertionError(tool + " ended with " + code + ": " + printed);
    }
    return printed.toString();
  }
}
