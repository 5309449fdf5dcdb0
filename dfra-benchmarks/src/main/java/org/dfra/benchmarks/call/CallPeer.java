package org.dfra.benchmarks.call;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.rmi.Remote;
import java.rmi.server.UnicastRemoteObject;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.InvocationLayerFactory;
import net.jini.jeri.ServerEndpoint;
import net.jini.jeri.tcp.TcpServerEndpoint;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.transport.TransportServerEndpoint;

/** What is compared: ways to call an object in another process of this computer. */
public enum CallPeer {

  /** Java RMI of the JDK. */
  RMI("Java RMI of the JDK", () -> new ProxyTransport(() -> {}, CallPeer::exportByRmi)),

  /** JERI as Apache River has it. */
  JERI(
      "JERI of Apache River, with River's own TCP endpoint and invocation layer",
      () -> new ProxyTransport(() -> {}, CallPeer::exportByJeri)),

  /** JeroMQ. */
  JEROMQ("JeroMQ, REQ and REP sockets by TCP, raw bytes instead of objects", JeroMqTransport::new),

  /** The transport of DFRA with the invocation layer of River. */
  TRANSPORT_TCP(
      "DFRA's transport by TCP with River's invocation layer: no deadline, no checks, no filters",
      () ->
          new ProxyTransport(
              () -> {}, (served, folder) -> export(served, tcpOnly(), new BasicILFactory()))),

  /** DFRA as robots and their clients use it. */
  DFRA_TCP(
      "DFRA by TCP, with the deadline of each call and the checks and filters of all streams",
      () ->
          new ProxyTransport(
              CallPeer::filterEverything,
              (served, folder) -> export(served, tcpOnly(), new DeadlineILFactory()))),

  /** DFRA between the members of a team. */
  DFRA_TLS(
      "the same between two members of a team: TLS 1.3, and a policy decides about each call",
      () ->
          new SecureTransport(
              new ProxyTransport(
                  CallPeer::filterEverything,
                  (served, folder) -> export(served, tcpOnly(), new DeadlineILFactory())))),

  /** DFRA on one computer, if a configuration says so. */
  DFRA_LOCAL(
      "dfra-tcp by a Unix-domain socket instead, if this computer has them",
      () ->
          new ProxyTransport(
              CallPeer::filterEverything,
              (served, folder) ->
                  export(
                      served,
                      Endpoints.withLocalSocket(CallTransport.HOST, 0),
                      new DeadlineILFactory())));

  /** The one that others are compared with. */
  public static final CallPeer REFERENCE = RMI;

  private final String description;
  private final Supplier<CallTransport> transport;

  CallPeer(String description, Supplier<CallTransport> transport) {
    this.description = description;
    this.transport = transport;
  }

  private static Remote exportByRmi(Remote served, Path folder) throws IOException {
    InetAddress loopback = InetAddress.getByName(CallTransport.HOST);
    return UnicastRemoteObject.exportObject(
        served, 0, null, port -> new ServerSocket(port, 0, loopback));
  }

  private static Remote exportByJeri(Remote served, Path folder) throws IOException {
    TcpServerEndpoint endpoint =
        TcpServerEndpoint.getInstance(
            CallTransport.HOST, 0, null, Endpoints.serverSocketFactory(CallTransport.HOST));
    return new BasicJeriExporter(endpoint, new BasicILFactory(), false, true).export(served);
  }

  private static ServerEndpoint tcpOnly() {
    return new TransportServerEndpoint(CallTransport.HOST, 0);
  }

  private static Remote export(
      Remote served, ServerEndpoint endpoint, InvocationLayerFactory factory) throws IOException {
    return JeriExporters.keepingAlive(endpoint, factory).export(served);
  }

  /** What a main of DFRA does first. */
  private static void filterEverything() throws IOException {
    SerialFilters.install();
    TrustedCode.install();
  }

  /** Its name in tables and records. */
  public String label() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** What it is, without a full stop. */
  public String description() {
    return description;
  }

  /** JVM options of its processes. */
  List<String> options() {
    return this == RMI ? List.of("-Djava.rmi.server.hostname=" + CallTransport.HOST) : List.of();
  }

  /** For one process, server or client. */
  CallTransport transport() {
    return transport.get();
  }
}
