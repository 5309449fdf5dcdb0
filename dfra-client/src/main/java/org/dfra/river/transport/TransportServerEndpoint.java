package org.dfra.river.transport;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Objects;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.io.UnsupportedConstraintException;
import net.jini.jeri.Endpoint;
import net.jini.jeri.RequestDispatcher;
import net.jini.jeri.ServerEndpoint;
import org.dfra.river.access.GuardedEndpoint;
import org.dfra.river.access.ListeningHost;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.transport.local.LocalSocket;
import org.dfra.security.Guard;
import org.jspecify.annotations.Nullable;

/**
 * Listens on one address: the one that the proxies carry. If that is wanted, also on a Unix-domain
 * socket, for clients on the same computer.
 *
 * <p>In a Jini configuration file, as any other server endpoint of JERI:
 *
 * <pre>
 *   exporter = JeriExporters.keepingAlive(new TransportServerEndpoint("192.0.2.10", 0), factory);
 * </pre>
 *
 * <p>If the {@linkplain CurrentIdentity current identity} is that of a member of a team, it accepts
 * encrypted connections only.
 *
 * <p>Objects that are exported on equal endpoints share the port.
 */
public final class TransportServerEndpoint
    implements ServerEndpoint, ListeningHost, GuardedEndpoint {

  private final String host;
  private final int port;
  private final boolean isLocalToo;
  private final @Nullable ChannelIdentity identity;

  /**
   * An endpoint that all clients reach by TCP.
   *
   * @param host address or name of this computer; proxies carry it, and only it is listened on
   * @param port TCP port, or 0 for one that the system chooses
   */
  public TransportServerEndpoint(String host, int port) {
    this(host, port, false, CurrentIdentity.get());
  }

  private TransportServerEndpoint(
      String host, int port, boolean isLocalToo, @Nullable ChannelIdentity identity) {
    this.identity = identity;
    this.host = Objects.requireNonNull(host, "host");
    this.port = port;
    this.isLocalToo = isLocalToo;
  }

  /**
   * An endpoint with a Unix-domain socket beside TCP, where the operating system has them.
   *
   * @param host address or name of this computer; proxies carry it, and only it is listened on
   * @param port TCP port, or 0 for one that the system chooses
   */
  public static TransportServerEndpoint withLocalSocket(String host, int port) {
    return new TransportServerEndpoint(host, port, true, CurrentIdentity.get());
  }

  @Override
  public String host() {
    return host;
  }

  @Override
  public InvocationConstraints checkConstraints(InvocationConstraints constraints)
      throws UnsupportedConstraintException {
    return identity == null
        ? TransportConstraints.checkPlain(constraints)
        : TransportConstraints.checkEncrypted(
            constraints, null, identity.subject().getPrincipals());
  }

  @Override
  public @Nullable Guard guard() {
    return identity == null ? null : identity.guard();
  }

  @Override
  public String robot() {
    return identity == null ? "" : identity.robot();
  }

  @Override
  public Endpoint enumerateListenEndpoints(ListenContext context) throws IOException {
    Listening listening = new Listening(host, port, isLocalToo, identity);
    ListenCookie cookie = context.addListenEndpoint(listening);
    if (!(cookie instanceof Cookie its)) {
      throw new IllegalArgumentException("a cookie of " + cookie.getClass().getName());
    }
    return new TransportEndpoint(host, its.port, its.local, identity);
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof TransportServerEndpoint endpoint
        && endpoint.host.equals(host)
        && endpoint.port == port
        && endpoint.isLocalToo == isLocalToo
        && endpoint.identity == identity;
  }

  @Override
  public int hashCode() {
    return Objects.hash(host, port, isLocalToo);
  }

  @Override
  public String toString() {
    return "TransportServerEndpoint[" + host + ":" + port + "]";
  }

  /** What its clients need to know. */
  private record Cookie(int port, @Nullable LocalSocket local) implements ListenCookie {}

  /** Where it listens. JERI compares these to share one port among objects. */
  private record Listening(
      String host, int port, boolean isLocalToo, @Nullable ChannelIdentity identity)
      implements ListenEndpoint {

    /** There are no permissions without a security manager. */
    @Override
    public void checkPermissions() {}

    private ServerPort open(RequestDispatcher dispatcher) throws IOException {
      try {
        return ServerPort.open(InetAddress.getByName(host), port, isLocalToo, dispatcher, identity);
      } catch (UnknownHostException e) {
        throw because(
            new UnknownHostException(
                "host " + host + " is not known; name an address of this machine"),
            e);
      } catch (BindException e) {
        throw because(
            new BindException(
                "cannot listen on "
                    + host
                    + ":"
                    + port
                    + " ("
                    + e.getMessage()
                    + "); name an address of this machine and a port that nobody uses"),
            e);
      }
    }

    private static <E extends IOException> E because(E failure, IOException cause) {
      failure.initCause(cause);
      return failure;
    }

    @Override
    public ListenHandle listen(RequestDispatcher dispatcher) throws IOException {
      ServerPort opened = open(dispatcher);
      Cookie cookie = new Cookie(opened.port(), opened.local());
      return new ListenHandle() {
        @Override
        public void close() {
          opened.close();
        }

        @Override
        public ListenCookie getCookie() {
          return cookie;
        }
      };
    }
  }
}
