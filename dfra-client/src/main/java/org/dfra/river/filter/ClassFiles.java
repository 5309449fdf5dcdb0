package org.dfra.river.filter;

import java.io.File;
import java.io.IOException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * Looks for the files of classes without asking the JDK's own class loaders for a file that they
 * may not have. They keep an entry for each such file, which a collection removes only when memory
 * is almost exhausted, and other computers choose the names.
 *
 * <p>As in the JDK's loaders, the places of the class path are those at the start, symbolic links
 * resolved: a link that is changed later changes nothing.
 *
 * <p>Thread-safe.
 */
final class ClassFiles {

  private static final ClassLoader APPLICATION = ClassLoader.getSystemClassLoader();

  /** What is added to the boot loader's class path has this package, which the JDK lost. */
  private static final String ADDED_PACKAGE = "java/rmi/activation";

  /** These load nothing. URL class loaders keep no entry for a file that they do not have. */
  private final URLClassLoader classPath;

  private final @Nullable URLClassLoader added;

  /**
   * @param classPath as in {@code java.class.path}
   * @param added what is added to the boot loader's class path; null if unknown
   */
  ClassFiles(String classPath, @Nullable String added) {
    this.classPath = new URLClassLoader(urls(classPath), null);
    this.added = added == null ? null : new URLClassLoader(urls(added), null);
  }

  private static URL[] urls(String classPath) {
    List<URL> urls = new ArrayList<>();
    for (String each : classPath.split(File.pathSeparator, -1)) { // an empty one: this folder
      try {
        urls.add(existing(Path.of(each).toAbsolutePath()).toUri().toURL());
      } catch (MalformedURLException e) {
        throw new IllegalStateException(each + " of the class path cannot be searched", e);
      }
    }
    return urls.toArray(URL[]::new);
  }

  private static Path existing(Path path) {
    try {
      return path.toRealPath();
    } catch (IOException e) { // it does not exist, and has no classes
      return path;
    }
  }

  /**
   * Whether a loader or one of its parents has a file.
   *
   * @param file as in {@code java/lang/String.class}
   */
  boolean has(String file, ClassLoader loader) {
    for (@Nullable ClassLoader each = loader; each != null; each = each.getParent()) {
      if (each == APPLICATION) {
        return isOfTheApplication(file);
      } else if (each instanceof TrustedLoader downloaded) {
        if (downloaded.hasFile(file)) {
          return true;
        }
      } else if (each instanceof URLClassLoader urls) {
        if (urls.findResource(file) != null) {
          return true;
        }
      } else { // of which only its author knows where it looks
        return each.getResource(file) != null;
      }
    }
    return isOfTheJdk(file) || isAdded(file);
  }

  private boolean isOfTheApplication(String file) {
    if (isInPackage(file, JdkPackages.NAMES)) {
      return isOfTheJdk(file);
    }
    return isInPackage(file, Set.of(ADDED_PACKAGE))
        ? isAdded(file)
        : classPath.findResource(file) != null;
  }

  /** For a file in a package of a module, the JDK's loaders keep no entry. */
  private static boolean isOfTheJdk(String file) {
    return isInPackage(file, JdkPackages.NAMES) && APPLICATION.getResource(file) != null;
  }

  private boolean isAdded(String file) {
    return isInPackage(file, Set.of(ADDED_PACKAGE))
        && (added == null ? APPLICATION.getResource(file) : added.findResource(file)) != null;
  }

  private static boolean isInPackage(String file, Set<String> packages) {
    int end = file.lastIndexOf('/');
    return end > 0 && packages.contains(file.substring(0, end));
  }

  /** Collected when they are first needed: robots start without. */
  private static final class JdkPackages {

    static final Set<String> NAMES =
        ModuleLayer.boot().modules().stream()
            .flatMap(module -> module.getPackages().stream())
            .map(name -> name.replace('.', '/'))
            .collect(Collectors.toUnmodifiableSet());

    private JdkPackages() {}
  }
}
