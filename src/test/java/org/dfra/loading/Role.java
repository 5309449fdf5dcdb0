package org.dfra.loading;

import java.io.BufferedReader;
import java.io.DataInputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import java.rmi.Remote;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import net.jini.discovery.OutgoingUnicastResponse;
import net.jini.export.Exporter;
import org.dfra.core.config.RobotXml;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.module.Module;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.ClassServer;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.server.Exporters;
import org.dfra.testing.InteractiveProcess;

/** What the test's processes do. Each says a line when it is ready and ends with its input. */
final class Role {

  static final String HOST = "127.0.0.1";
  private static final UUID ID = new UUID(0x4000, Long.MIN_VALUE);
  private static Object kept = "";

  private Role() {}

  public static void main(String[] args) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    switch (args[0]) {
      case "registrar" -> registrar(args[1]);
      case "server" ->
          server(Integer.parseInt(args[1]), Integer.parseInt(args[2]), args[3], args[4]);
      case "hostile" -> hostile(args[1]);
      case "robot" -> robot(args[1], Integer.parseInt(args[2]), args[3]);
      case "client" -> client();
      default -> throw new IllegalArgumentException(args[0]);
    }
    System.exit(0);
  }

  /** Stock reggie on one port of loopback, without multicast. */
  private static void registrar(String configuration) throws Exception {
    Constructor<?> constructor =
        Class.forName("com.sun.jini.reggie.TransientRegistrarImpl")
            .getDeclaredConstructor(String[].class, Class.forName("com.sun.jini.start.LifeCycle"));
    constructor.setAccessible(true);
    kept = constructor.newInstance(new String[] {configuration}, null);
    LookupLocator at = (LookupLocator) kept.getClass().getMethod("getLocator").invoke(kept);
    say(Integer.toString(at.getPort()));
    System.in.read();
  }

  /** A laser scanner with its class server; how the annotation is changed, if at all. */
  private static void server(int registrar, int port, String folder, String lie) throws Exception {
    ClassServer classes = new ClassServer(HOST, port, Path.of(folder), List.of("lidar-dl.jar"));
    classes.start();
    annotate(classes.codebase(), lie);
    Class<?> remote = Class.forName("sample.lidar.RemoteLidar");
    InvocationHandler lidar =
        (proxy, method, arguments) ->
            switch (method.getName()) {
              case "scan" -> new double[] {1, 2, 3};
              case "readiness", "awaitReadiness" -> Readiness.READY;
              case "hashCode" -> System.identityHashCode(proxy);
              case "equals" -> proxy == arguments[0];
              case "toString" -> "lidar";
              default -> throw new UnsupportedOperationException(method.getName());
            };
    Remote impl =
        (Remote) Proxy.newProxyInstance(remote.getClassLoader(), new Class<?>[] {remote}, lidar);
    kept = impl;
    Exporter exporter = Exporters.jeri(HOST, 5000L);
    Object proxy =
        Class.forName("sample.lidar.LidarProxy")
            .getConstructor(RemoteModule.class, UUID.class, Identification.class)
            .newInstance(
                exporter.export(impl),
                ID,
                new Identification("atrv1", "lidar", "Laser scanner", "Test", "1"));
    ServiceID id = new ServiceID(ID.getMostSignificantBits(), ID.getLeastSignificantBits());
    find(registrar).register(new ServiceItem(id, proxy, null), 120_000);
    say(Integer.toString(classes.port()));
    System.in.read();
  }

  private static void annotate(String codebase, String lie) {
    switch (lie) {
      case "honest" -> TrustedCode.annotate(codebase);
      case "tampered" -> TrustedCode.annotate(codebase.replaceAll("=.*", "=" + "0".repeat(64)));
      default -> // as another kind of URL
          System.setProperty(
              "java.rmi.server.codebase",
              codebase.replace("httpmd:", "http:").replaceAll(";.*", ""));
    }
  }

  /** Answers unicast discovery with a registrar of its own, its class served correctly. */
  private static void hostile(String folder) throws Exception {
    ClassServer classes = new ClassServer(HOST, 0, Path.of(folder), List.of("registrar-dl.jar"));
    classes.start();
    TrustedCode.annotate(classes.codebase());
    ServiceRegistrar evil =
        (ServiceRegistrar) Class.forName("sample.evil.Registrar").getConstructor().newInstance();
    try (ServerSocket server = new ServerSocket(0, 5, InetAddress.getByName(HOST))) {
      say(Integer.toString(server.getLocalPort()));
      Thread answers = new Thread(() -> answer(server, evil), "hostile registrar");
      answers.setDaemon(true);
      answers.start();
      System.in.read();
    }
  }

  private static void answer(ServerSocket server, ServiceRegistrar evil) {
    while (!server.isClosed()) {
      try (Socket socket = server.accept()) {
        new DataInputStream(socket.getInputStream()).readInt(); // the protocol's version
        OutgoingUnicastResponse.marshal(socket.getOutputStream(), evil, new String[0]);
      } catch (java.io.IOException e) {
        // the next one
      }
    }
  }

  /** For each robot's XML on its input: brings it up and says what it says of its class server. */
  private static void robot(String host, int port, String state) throws Exception {
    say("ready");
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    for (String xml; (xml = in.readLine()) != null; ) {
      RobotBootstrap bootstrap =
          new RobotBootstrap(
              new PhoenixProcess(host, port, -1, Path.of(state)), RobotXml.read(Path.of(xml)));
      bootstrap.up();
      say(bootstrap.codebase().orElseThrow().findUnserved().orElse("all is served"));
    }
  }

  /** For each port on its input: what it finds in the registrar there; "again": the last one. */
  private static void client() throws Exception {
    say("ready");
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    for (String port; (port = in.readLine()) != null; ) {
      try {
        Object found =
            port.equals("again")
                ? kept
                : find(Integer.parseInt(port))
                    .lookup(new ServiceTemplate(null, new Class<?>[] {Module.class}, null));
        kept = found;
        Object[] answers = {
          found.getClass().getMethod("build").invoke(found),
          ((double[]) found.getClass().getMethod("scan").invoke(found)).length,
          ((Module) found).identification().path(),
          ((Module) found).readiness()
        };
        say("found " + List.of(answers));
      } catch (Exception e) {
        StringBuilder why = new StringBuilder("refused");
        for (Throwable at = e; at != null; at = at.getCause()) {
          why.append(": ").append(at);
        }
        say(why.toString().replaceAll("\\s+", " "));
      }
    }
  }

  private static ServiceRegistrar find(int port) throws Exception {
    return new LookupLocator(HOST, port).getRegistrar(10_000);
  }

  private static void say(String line) {
    System.out.println(InteractiveProcess.RESPONSE_PREFIX + line);
  }

  /**
   * Starts a process in a role.
   *
   * @param path what is on its class path besides the test's own
   */
  static InteractiveProcess start(List<Path> path, List<String> options, String... role)
      throws IOException {
    List<String> command = new ArrayList<>(InteractiveProcess.java(classPath(path), options));
    command.add(Role.class.getName());
    command.addAll(List.of(role));
    return new InteractiveProcess(command);
  }

  /** A class path of this one and what else. */
  static String classPath(List<Path> more) {
    StringBuilder path = new StringBuilder(System.getProperty("java.class.path"));
    more.forEach(each -> path.append(File.pathSeparator).append(each));
    return path.toString();
  }
}
