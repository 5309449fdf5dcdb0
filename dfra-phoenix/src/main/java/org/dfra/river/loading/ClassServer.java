package org.dfra.river.loading;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.StringJoiner;
import org.dfra.river.loading.HttpListener.HttpResponder;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Serves the robot's {@code -dl} jars over HTTP, and provides their codebase annotation.
 *
 * <p>The jars are read when it starts: their digests are those of the bytes it serves, also if a
 * jar is rebuilt meanwhile. It serves only these jars and, with a {@link JarStore}, their former
 * versions. Slow clients are limited ({@link HttpListener}). Its threads, {@code class server n},
 * run from {@link #start} to {@link #close}.
 */
public final class ClassServer implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(ClassServer.class);

  private final String host;
  private final int port;
  private final Map<String, Path> files;
  private final @Nullable JarStore kept;

  @GuardedBy("this")
  private Map<String, ServedJar> jars = Map.of();

  @GuardedBy("this")
  private @Nullable HttpListener server;

  private record ServedJar(byte[] bytes, String digest) {}

  /** What URLs and River's own clients append to a jar's name, before its digest. */
  static final String DIGEST = ";sha-256=";

  /**
   * What River's own clients append to a jar's name instead. Since Java 9, a class loader opens a
   * jar by its URL with the fragment {@code #runtime}; River's handler of {@code httpmd:} URLs
   * takes the digest out of the path, and leaves the fragment there, without its {@code #}.
   */
  private static final String FRAGMENT = "runtime";

  /**
   * @param host address or name of this machine; only it is listened on, and annotations carry it
   * @param port TCP port, the same after every restart; 0 for one that the system chooses, which
   *     breaks annotations that others have stored
   * @param folder of the jars
   * @param jars their names, such as {@code dfra-client.jar}
   * @throws IllegalArgumentException if a name is not that of a jar in that folder
   */
  public ClassServer(String host, int port, Path folder, List<String> jars) {
    this(host, port, inFolder(folder, jars), null);
  }

  /**
   * @param files the jars by the names they are served under
   * @param kept store of the jars' former versions; null for none
   */
  ClassServer(String host, int port, Map<String, Path> files, @Nullable JarStore kept) {
    this.host = host;
    this.port = port;
    this.files = Collections.unmodifiableMap(new LinkedHashMap<>(files));
    this.kept = kept;
    files.keySet().forEach(ClassServer::checkName);
  }

  private static Map<String, Path> inFolder(Path folder, List<String> jars) {
    Map<String, Path> files = new LinkedHashMap<>();
    for (String name : jars) {
      checkName(name);
      files.put(name, folder.resolve(name));
    }
    return files;
  }

  /**
   * Reads the jars and serves them. Does nothing if it is started.
   *
   * @throws IOException if a jar cannot be read or the port is not available
   */
  public synchronized void start() throws IOException {
    if (server != null) {
      return;
    }
    Map<String, ServedJar> read = new LinkedHashMap<>();
    for (Map.Entry<String, Path> file : files.entrySet()) {
      byte[] bytes = read(file.getValue());
      read.put(file.getKey(), new ServedJar(bytes, Digests.sha256(bytes)));
    }
    InetSocketAddress address = new InetSocketAddress(host, port);
    jars = read;
    try {
      server = HttpListener.start(address, this::answer);
    } catch (IOException | RuntimeException e) {
      throw new IOException(
          "the class server cannot listen on "
              + host
              + ":"
              + port
              + " ("
              + e.getMessage()
              + "); stop the program that uses it, or name another address or port",
          e);
    }
    LOG.info("Serving {} at {}:{}.", files.keySet(), host, server.port());
  }

  /** Stops serving. Does nothing if it is not started. */
  @Override
  public synchronized void close() {
    if (server != null) {
      server.close();
      server = null;
    }
  }

  /** The TCP port it listens on. */
  public synchronized int port() {
    return started().port();
  }

  /**
   * The annotation of classes that are in these jars, {@code httpmd://host:port/name.jar;sha-256=…}
   * each.
   *
   * @param jars names of jars it serves; all of them if none is named
   * @throws IllegalStateException if it is not started
   * @throws IllegalArgumentException if it does not serve one of them
   */
  public synchronized String codebase(String... jars) {
    int listening = started().port();
    StringJoiner urls = new StringJoiner(" ");
    for (String name : jars.length == 0 ? files.keySet() : List.of(jars)) {
      urls.add(url(host, listening, name, served(name).digest()));
    }
    return urls.toString();
  }

  /**
   * The annotation with which another virtual machine of this robot serves these jars: the digests
   * are computed from the current files.
   *
   * @throws IOException if a jar cannot be read
   */
  public static String codebase(String host, int port, Path folder, List<String> jars)
      throws IOException {
    List<String> urls = new ArrayList<>();
    for (Map.Entry<String, Path> file : inFolder(folder, jars).entrySet()) {
      urls.add(url(host, port, file.getKey(), Digests.sha256(read(file.getValue()))));
    }
    return String.join(" ", urls);
  }

  @GuardedBy("this")
  private HttpListener started() {
    if (server == null) {
      throw new IllegalStateException("the class server of " + files.keySet() + " is not started");
    }
    return server;
  }

  @GuardedBy("this")
  private ServedJar served(String name) {
    ServedJar jar = jars.get(name);
    if (jar == null) {
      throw new IllegalArgumentException(
          "the class server does not serve "
              + name
              + ", only "
              + files.keySet()
              + "; add it there");
    }
    return jar;
  }

  static String url(String host, int port, String name, String digest) {
    String place = host.contains(":") ? "[" + host + "]" : host;
    return "httpmd://" + place + ":" + port + "/" + name + DIGEST + digest;
  }

  static void checkName(String name) {
    if (!name.matches("[A-Za-z0-9_][A-Za-z0-9._-]*\\.jar")) {
      throw new IllegalArgumentException(
          "\"" + name + "\" is not the name of a jar: letters, digits, . _ - and .jar at its end");
    }
  }

  static byte[] read(Path file) throws IOException {
    try {
      return Files.readAllBytes(file);
    } catch (IOException e) {
      throw new IOException("the jar " + file + " cannot be served (" + e + "); build it first", e);
    }
  }

  private HttpResponder.HttpReply answer(String path) throws IOException {
    ServedJar jar = asked(path);
    return jar == null
        ? HttpResponder.HttpReply.NOT_FOUND
        : new HttpResponder.HttpReply(
            200,
            Map.of("Content-Type", "application/java-archive", "ETag", etag(jar.digest())),
            jar.bytes());
  }

  /** The form of a jar's digest in a response header. */
  static String etag(String digest) {
    return '"' + digest + '"';
  }

  /**
   * Looks up the jar of a path. The path is a key, never a file's name. A request for an
   * unavailable digest gets the current jar of that name, so that the client can report the
   * difference.
   */
  private @Nullable ServedJar asked(String path) throws IOException {
    if (!path.startsWith("/")) {
      return null;
    }
    int at = path.indexOf(DIGEST);
    String name = path.substring(1, at < 0 ? path.length() : at);
    ServedJar now = now(name);
    if (at < 0) {
      return now != null || !name.endsWith(".jar" + FRAGMENT)
          ? now
          : now(name.substring(0, name.length() - FRAGMENT.length()));
    }
    String digest = path.substring(at + DIGEST.length());
    if (!Digests.isSha256(digest)) {
      return null;
    }
    if (kept != null && (now == null || !now.digest().equals(digest))) {
      byte @Nullable [] older = kept.find(digest);
      return older == null ? now : new ServedJar(older, digest);
    }
    return now;
  }

  private synchronized @Nullable ServedJar now(String name) {
    return jars.get(name);
  }
}
