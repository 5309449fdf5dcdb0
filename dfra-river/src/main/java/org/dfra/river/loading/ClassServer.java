package org.dfra.river.loading;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Serves the robot's {@code -dl} jars over HTTP, and says with which annotation.
 *
 * <p>The jars are read when it starts: their digests are those of the bytes it serves, also if a
 * jar is rebuilt meanwhile. Nothing but these jars can be asked for. Its threads, {@code class
 * server n}, live from {@link #start} to {@link #close}.
 */
public final class ClassServer implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(ClassServer.class);

  private static final int THREADS = 8;

  private final String host;
  private final int port;
  private final Path folder;
  private final List<String> names;
  private Map<String, Jar> jars = Map.of(); // guarded by this
  private @Nullable HttpServer server; // guarded by this
  private @Nullable ExecutorService threads; // guarded by this

  private record Jar(byte[] bytes, String digest) {}

  /**
   * @param host address or name of this machine; only it is listened on, and annotations carry it
   * @param port TCP port, the same after every restart; 0 for one of the system's choice, which
   *     breaks annotations that others keep
   * @param folder where the jars are
   * @param jars their names, such as {@code dfra-river-dl.jar}
   * @throws IllegalArgumentException if a name is none of a jar in that folder
   */
  public ClassServer(String host, int port, Path folder, List<String> jars) {
    this.host = host;
    this.port = port;
    this.folder = folder;
    this.names = List.copyOf(jars);
    names.forEach(ClassServer::checkName);
  }

  /**
   * Reads the jars and serves them. Does nothing if it is started.
   *
   * @throws IOException if a jar cannot be read or the port cannot be had
   */
  public synchronized void start() throws IOException {
    if (server != null) {
      return;
    }
    Map<String, Jar> read = new LinkedHashMap<>();
    for (String name : names) {
      read.put(name, read(folder, name));
    }
    // A client that stalls gives its thread back; the JDK's server reads these once.
    System.getProperties().putIfAbsent("sun.net.httpserver.maxReqTime", "10");
    System.getProperties().putIfAbsent("sun.net.httpserver.maxRspTime", "60");
    InetSocketAddress address = new InetSocketAddress(host, port);
    HttpServer starting;
    try {
      starting = HttpServer.create(address, 0);
    } catch (IOException | RuntimeException e) {
      throw new IOException(
          "the class server cannot listen on "
              + host
              + ":"
              + port
              + " ("
              + e.getMessage()
              + "); end what does, or name another address or port",
          e);
    }
    jars = read;
    threads = threads();
    starting.setExecutor(threads);
    starting.createContext("/", this::answer);
    starting.start();
    server = starting;
    LOG.info("Serving {} at {}:{}.", names, host, starting.getAddress().getPort());
  }

  /** Serves nothing any more. Does nothing if it is not started. */
  @Override
  public synchronized void close() {
    if (server != null) {
      server.stop(0);
      server = null;
    }
    if (threads != null) {
      threads.shutdownNow();
      threads = null;
    }
  }

  /** The TCP port it listens on. */
  public synchronized int port() {
    return started().getAddress().getPort();
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
    int listening = started().getAddress().getPort();
    return (jars.length == 0 ? names.stream() : Arrays.stream(jars))
        .map(name -> url(host, listening, name, served(name).digest()))
        .collect(Collectors.joining(" "));
  }

  /**
   * The annotation with which another virtual machine of this robot serves these jars: digests come
   * from the files as they are now.
   *
   * @throws IOException if a jar cannot be read
   */
  public static String codebase(String host, int port, Path folder, List<String> jars)
      throws IOException {
    List<String> urls = new ArrayList<>();
    for (String name : jars) {
      checkName(name);
      urls.add(url(host, port, name, read(folder, name).digest()));
    }
    return String.join(" ", urls);
  }

  private HttpServer started() {
    if (server == null) {
      throw new IllegalStateException("the class server of " + folder + " is not started");
    }
    return server;
  }

  private Jar served(String name) {
    Jar jar = jars.get(name);
    if (jar == null) {
      throw new IllegalArgumentException(
          "the class server does not serve " + name + ", only " + names + "; add it there");
    }
    return jar;
  }

  private static String url(String host, int port, String name, String digest) {
    String place = host.contains(":") ? "[" + host + "]" : host;
    return "httpmd://" + place + ":" + port + "/" + name + ";sha-256=" + digest;
  }

  private static void checkName(String name) {
    if (!name.matches("[A-Za-z0-9_][A-Za-z0-9._-]*\\.jar")) {
      throw new IllegalArgumentException(
          "\"" + name + "\" is no name of a jar: letters, digits, . _ - and .jar at its end");
    }
  }

  private static Jar read(Path folder, String name) throws IOException {
    Path file = folder.resolve(name);
    try {
      byte[] bytes = Files.readAllBytes(file);
      return new Jar(bytes, Digests.sha256(bytes));
    } catch (IOException e) {
      throw new IOException("the jar " + file + " cannot be served (" + e + "); build it first", e);
    }
  }

  private static ExecutorService threads() {
    AtomicInteger number = new AtomicInteger();
    ThreadPoolExecutor pool =
        new ThreadPoolExecutor(
            THREADS,
            THREADS,
            10,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            task -> {
              Thread thread = Executors.defaultThreadFactory().newThread(task);
              thread.setName("class server " + number.incrementAndGet());
              thread.setDaemon(true);
              return thread;
            });
    pool.allowCoreThreadTimeOut(true);
    return pool;
  }

  private void answer(HttpExchange exchange) throws IOException {
    try (exchange) {
      String method = exchange.getRequestMethod();
      boolean head = method.equals("HEAD");
      if (!head && !method.equals("GET")) {
        exchange.getResponseHeaders().set("Allow", "GET, HEAD");
        exchange.sendResponseHeaders(405, -1);
        return;
      }
      Jar jar = asked(exchange.getRequestURI().getRawPath());
      if (jar == null) {
        exchange.sendResponseHeaders(404, -1);
        return;
      }
      exchange.getResponseHeaders().set("Content-Type", "application/java-archive");
      if (head) {
        exchange.getResponseHeaders().set("Content-Length", Integer.toString(jar.bytes().length));
        exchange.sendResponseHeaders(200, -1);
        return;
      }
      exchange.sendResponseHeaders(200, jar.bytes().length);
      exchange.getResponseBody().write(jar.bytes());
    }
  }

  /** The path is a key, never a file's name; River's own clients leave the digest in it. */
  private synchronized @Nullable Jar asked(@Nullable String path) {
    if (path == null || !path.startsWith("/")) {
      return null;
    }
    int digest = path.indexOf(";sha-256=");
    Jar jar = jars.get(path.substring(1, digest < 0 ? path.length() : digest));
    return jar == null || digest < 0 || path.endsWith("=" + jar.digest()) ? jar : null;
  }
}
