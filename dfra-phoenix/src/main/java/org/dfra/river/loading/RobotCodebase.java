package org.dfra.river.loading;

import java.io.ByteArrayInputStream;
import java.io.File;
import java.io.IOException;
import java.net.HttpURLConnection;
import java.net.Proxy;
import java.net.URI;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Properties;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.JarEntry;
import java.util.jar.JarInputStream;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.core.config.RenamedNames;

/**
 * The jars that a robot serves to clients without its classes, and their server. The settings are
 * passed to a robot's groups by their virtual machines' options; {@link GroupCodebasePublisher}
 * applies them in each group.
 *
 * @param host address or name at which the robot's class server listens
 * @param port its TCP port
 * @param storeFolder folder of the jars that were ever part of an annotation, at most the newest 64
 * @param moduleCodebases for each kind of module with jars of its own, the jars with its classes
 * @param commonJars the jars with all other classes of the class path, DFRA's own
 */
public record RobotCodebase(
    String host,
    int port,
    Path storeFolder,
    List<List<Path>> moduleCodebases,
    List<Path> commonJars) {

  private static final String ADDRESS = "dfra.class-server";
  private static final String SERVE = "dfra.class-server.serve";
  private static final String STORE = "dfra.class-server.store";
  private static final String MODULE = "dfra.class-server.module.";
  private static final String COMMON = "dfra.class-server.common";
  private static final int PATIENCE_MILLIS = 2000;

  public RobotCodebase {
    moduleCodebases =
        moduleCodebases.stream()
            .filter(jars -> !jars.isEmpty())
            .distinct()
            .map(List::copyOf)
            .toList();
    commonJars = List.copyOf(commonJars);
  }

  /** One jar with its current contents. */
  record Jar(String name, byte[] bytes, String digest, Set<String> classes) {}

  /** Whether there is nothing to serve. */
  public boolean isEmpty() {
    return moduleCodebases.isEmpty() && commonJars.isEmpty();
  }

  /**
   * The options that pass these settings to a group of this robot.
   *
   * @param serves whether the group runs the class server
   */
  public List<String> options(boolean serves) {
    List<String> options = new ArrayList<>();
    options.add("-D" + ADDRESS + "=" + host + ":" + port);
    options.add("-D" + SERVE + "=" + serves);
    options.add("-D" + STORE + "=" + storeFolder);
    for (int i = 0; i < moduleCodebases.size(); i++) {
      options.add("-D" + MODULE + i + "=" + text(moduleCodebases.get(i)));
    }
    if (!commonJars.isEmpty()) {
      options.add("-D" + COMMON + "=" + text(commonJars));
    }
    return options;
  }

  /** The port at which a group with these options serves classes; empty if it serves none. */
  public static Optional<Integer> servedPort(List<String> recorded) {
    List<String> options = recorded.stream().map(RenamedNames::resolveOption).toList();
    String place = "-D" + ADDRESS + "=";
    return options.contains("-D" + SERVE + "=true")
        ? options.stream()
            .filter(each -> each.startsWith(place))
            .map(each -> Integer.valueOf(each.substring(each.lastIndexOf(':') + 1)))
            .findFirst()
        : Optional.empty();
  }

  /** The settings from this virtual machine's options; empty if its robot serves nothing. */
  static Optional<RobotCodebase> fromProperties(Properties properties) {
    String place = RenamedNames.property(properties, ADDRESS);
    if (place == null) {
      return Optional.empty();
    }
    List<List<Path>> kinds = new ArrayList<>();
    for (String jars; (jars = RenamedNames.property(properties, MODULE + kinds.size())) != null; ) {
      kinds.add(paths(jars));
    }
    int colon = place.lastIndexOf(':');
    return Optional.of(
        new RobotCodebase(
            place.substring(0, colon),
            Integer.parseInt(place.substring(colon + 1)),
            Path.of(Objects.requireNonNullElse(RenamedNames.property(properties, STORE), "")),
            kinds,
            paths(Objects.requireNonNullElse(RenamedNames.property(properties, COMMON), ""))));
  }

  /** Whether this virtual machine's options have it run the class server. */
  static boolean serves(Properties properties) {
    return Boolean.parseBoolean(RenamedNames.property(properties, SERVE));
  }

  private static String text(List<Path> jars) {
    return jars.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator));
  }

  private static List<Path> paths(String text) {
    return Arrays.stream(text.split(File.pathSeparator))
        .filter(each -> !each.isEmpty())
        .map(Path::of)
        .toList();
  }

  /** Each codebase, those of single kinds first. */
  Stream<List<Path>> codebases() {
    return Stream.concat(moduleCodebases.stream(), Stream.of(commonJars))
        .filter(jars -> !jars.isEmpty());
  }

  /** The jars by the names they are served under. */
  Map<String, Path> files() {
    Map<String, Path> files = new LinkedHashMap<>();
    codebases().flatMap(List::stream).forEach(jar -> files.put(jar.getFileName().toString(), jar));
    return files;
  }

  /** The annotation of classes that are in these jars. */
  String annotation(List<Jar> jars) {
    return jars.stream()
        .map(jar -> ClassServer.url(host, port, jar.name(), jar.digest()))
        .collect(Collectors.joining(" "));
  }

  /**
   * Reads every jar, so that errors are found before a group is started.
   *
   * @throws IOException naming a jar that cannot be read, is invalid, or has the name of another
   */
  public void check() throws IOException {
    Map<String, Path> names = new HashMap<>();
    for (List<Path> codebase : codebases().toList()) {
      for (Path file : codebase) {
        Path same = names.putIfAbsent(file.getFileName().toString(), file);
        if (same != null && !same.equals(file)) {
          throw new IOException(
              "two jars to download have one name, " + same + " and " + file + "; rename one");
        }
        read(file);
      }
    }
  }

  /**
   * Checks that the class server has the current version of every jar.
   *
   * @return the missing jars and the reason, as a sentence; empty if all are served
   * @throws IOException if a jar cannot be read
   */
  public Optional<String> findUnserved() throws IOException {
    for (Path file : files().values()) {
      Jar jar = read(file);
      String url = ClassServer.url(host, port, jar.name(), jar.digest());
      Optional<String> fault = fault(CodebaseUrl.parse(url).get(0));
      if (fault.isPresent()) {
        return Optional.of(
            "clients that lack "
                + jar.name()
                + " cannot download it from "
                + host
                + ":"
                + port
                + ": "
                + fault.get());
      }
    }
    return Optional.empty();
  }

  private static Optional<String> fault(CodebaseUrl url) {
    try {
      HttpURLConnection asked =
          (HttpURLConnection)
              URI.create(url.location() + ClassServer.DIGEST + url.digest())
                  .toURL()
                  .openConnection(Proxy.NO_PROXY);
      asked.setConnectTimeout(PATIENCE_MILLIS);
      asked.setReadTimeout(PATIENCE_MILLIS);
      asked.setRequestMethod("HEAD");
      int status = asked.getResponseCode();
      String etag = asked.getHeaderField("ETag");
      asked.disconnect();
      if (status != 200) {
        return Optional.of(
            "what listens there answers "
                + status
                + "; end it, or give the robot's class server another port");
      }
      return ClassServer.etag(url.digest()).equals(etag)
          ? Optional.empty()
          : Optional.of("it has other contents there; restart the registrar's group");
    } catch (IOException e) {
      return Optional.of("no class server answers (" + e + "); see the registrar group's log");
    }
  }

  /**
   * Reads a jar and the names of its classes.
   *
   * @throws IOException if it cannot be read or is empty
   */
  static Jar read(Path file) throws IOException {
    String name = file.getFileName().toString();
    byte[] bytes = ClassServer.read(file);
    Set<String> classes = new TreeSet<>();
    boolean empty = true;
    try (JarInputStream in = new JarInputStream(new ByteArrayInputStream(bytes), false)) {
      for (JarEntry entry; (entry = in.getNextJarEntry()) != null; ) {
        empty = false;
        String path = entry.getName();
        if (path.endsWith(".class") && !path.startsWith("META-INF/")) {
          classes.add(path.substring(0, path.length() - ".class".length()).replace('/', '.'));
        }
      }
    }
    if (empty) {
      throw new IOException(
          "the jar " + file + " cannot be served: it is not a jar, or it is empty; rebuild it");
    }
    return new Jar(name, bytes, Digests.sha256(bytes), classes);
  }
}
