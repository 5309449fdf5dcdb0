package org.dfra.core.query;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Modifier;
import java.net.URISyntaxException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Finds the types of a jar, or of a folder of classes. */
final class TypeFinder {

  private static final String CLASS = ".class";

  private TypeFinder() {}

  /**
   * The public top-level types that come from the same jar or folder as this one.
   *
   * @throws IllegalStateException if it comes from neither
   */
  static List<Class<?>> besides(Class<?> type) {
    try {
      Path place = Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
      if (Files.isDirectory(place)) {
        return in(place, type.getClassLoader());
      }
      try (FileSystem jar = FileSystems.newFileSystem(place)) {
        return in(jar.getPath("/"), type.getClassLoader());
      }
    } catch (IOException e) {
      throw new UncheckedIOException("the jar of " + type.getName() + " cannot be read: " + e, e);
    } catch (URISyntaxException | IllegalArgumentException e) {
      throw new IllegalStateException(type.getName() + " comes from no file: " + e, e);
    }
  }

  private static List<Class<?>> in(Path root, ClassLoader loader) throws IOException {
    try (Stream<Path> files = Files.walk(root)) {
      return files
          .map(file -> root.relativize(file).toString())
          .filter(TypeFinder::isTopLevel)
          .map(name -> name.substring(0, name.length() - CLASS.length()))
          .map(name -> load(name.replace('/', '.').replace('\\', '.'), loader))
          .filter(found -> Modifier.isPublic(found.getModifiers()))
          .collect(Collectors.toUnmodifiableList());
    }
  }

  private static boolean isTopLevel(String name) {
    return name.endsWith(CLASS) && name.indexOf('$') < 0 && !name.endsWith("-info" + CLASS);
  }

  private static Class<?> load(String name, ClassLoader loader) {
    try {
      return Class.forName(name, false, loader);
    } catch (ClassNotFoundException e) {
      throw new IllegalStateException(name + " is in its jar and cannot be loaded", e);
    }
  }
}
