package org.dfra.build;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.JarURLConnection;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Stream;

/** The names of classes that are not tests', by the files of the class path. */
public final class MainClassNames {

  private static final String ENDING = ".class";

  private MainClassNames() {}

  /**
   * The classes below a folder of the class path, nested ones included.
   *
   * @param folder such as {@code org/dfra}
   */
  public static SortedSet<String> below(String folder) {
    SortedSet<String> names = new TreeSet<>();
    try {
      for (URL each :
          Collections.list(MainClassNames.class.getClassLoader().getResources(folder))) {
        if (each.getProtocol().equals("jar")) {
          addOfJar(each, folder, names);
        } else if (!isOfTests(each.getPath())) {
          addOfFolder(Path.of(new URI(each.toString())), folder, names);
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
    return names;
  }

  /** As Maven and Gradle name the folders of their tests' classes. */
  private static boolean isOfTests(String path) {
    return path.contains("/test-classes/") || path.contains("/classes/java/test/");
  }

  private static void addOfJar(URL folder, String prefix, SortedSet<String> names)
      throws IOException {
    JarURLConnection jar = (JarURLConnection) folder.openConnection();
    jar.getJarFile().stream()
        .map(entry -> entry.getName())
        .filter(name -> name.startsWith(prefix + "/"))
        .forEach(name -> add(name, names));
  }

  private static void addOfFolder(Path folder, String prefix, SortedSet<String> names)
      throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      files.forEach(file -> add(prefix + "/" + folder.relativize(file), names));
    }
  }

  private static void add(String file, SortedSet<String> names) {
    if (file.endsWith(ENDING)
        && List.of("package-info", "module-info").stream()
            .noneMatch(each -> file.endsWith(each + ENDING))) {
      names.add(file.substring(0, file.length() - ENDING.length()).replace('/', '.'));
    }
  }
}
