package org.dfra.river.transport;

import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serializable;
import java.net.InetAddress;
import java.util.Objects;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.OutboundRequestIterator;
import net.jini.security.proxytrust.TrustEquivalence;
import org.dfra.river.access.NumericAddress;
import org.dfra.river.access.OwnAddresses;
import org.dfra.river.identity.AnonymousIdentity;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.transport.local.LocalSocket;
import org.jspecify.annotations.Nullable;

/**
 * The client's side of a {@link TransportServerEndpoint}: where it listens, by TCP and, for clients
 * on its own computer, by a Unix-domain socket.
 *
 * <p>If the {@linkplain CurrentIdentity current identity} is that of a member of a team, calls are
 * encrypted, and only members answer them.
 *
 * <p>Equal endpoints with the same local socket share their connections. Each request has a
 * connection of its own while it lasts.
 */
public final class TransportEndpoint implements AbortableEndpoint, TrustEquivalence, Serializable {

  private static final long serialVersionUID = 1L;

  private static final int MAX_PORT = 0xffff;

  private final String host;
  private final int port;

  // the local socket, or null and zeros: no class of its own, which would be sent along
  private final @Nullable String computer;
  private final @Nullable String path;
  private final long serverHigh;
  private final long serverLow;

  /** Whether its server encrypts, for a client that has joined no team; others encrypt always. */
  private final boolean isEncrypted;

  private transient @Nullable LocalSocket local;
  private transient @Nullable ChannelIdentity identity;
  private transient volatile ClientConnections.@Nullable Key key;

  /**
   * An endpoint that is only reached by TCP.
   *
   * @param host address or name that the server listens on
   * @param port TCP port, 1 to 65535
   * @throws IllegalArgumentException if the port is none
   */
  public TransportEndpoint(String host, int port) {
    this(host, port, null);
  }

  TransportEndpoint(String host, int port, @Nullable LocalSocket local) {
    this(host, port, local, CurrentIdentity.get());
  }

  TransportEndpoint(
      String host, int port, @Nullable LocalSocket local, @Nullable ChannelIdentity identity) {
    this.identity = identity;
    this.isEncrypted = identity != null;
    this.host = Objects.requireNonNull(host, "host");
    this.port = port;
    this.local = local;
    this.computer = local == null ? null : local.computer();
    this.path = local == null ? null : local.path();
    this.serverHigh = local == null ? 0 : local.server().getMostSignificantBits();
    this.serverLow = local == null ? 0 : local.server().getLeastSignificantBits();
    if (port < 1 || port > MAX_PORT) {
      throw new IllegalArgumentException("port " + port + " is not within 1 to " + MAX_PORT);
    }
  }

  @Override
  public String host() {
    return host;
  }

  @Override
  public int port() {
    return port;
  }

  @Override
  public void closeIdleConnections() {
    ClientConnections.to(this).closeIdle();
  }

  @Override
  public OutboundRequestIterator newRequest(InvocationConstraints constraints) {
    return RequestIterator.of(ClientConnections.to(this), constraints);
  }

  @Override
  public @Nullable ChannelIdentity identity() {
    return identity == null && isEncrypted ? AnonymousIdentity.instance() : identity;
  }

  /** What its calls share connections by. */
  ClientConnections.Key key() {
    ClientConnections.Key made = key;
    if (made == null) {
      made = new ClientConnections.Key(this, local, identity(), null, 0);
      key = made; // equal ones may be made at once
    }
    return made;
  }

  /**
   * The Unix-domain socket, if this program may use it: it runs on the computer of the endpoint's
   * host. An endpoint that was received could name any host and any socket.
   */
  @Nullable LocalSocket usableLocalSocket() {
    @Nullable LocalSocket socket = local;
    if (socket == null || !socket.isHere()) {
      return null;
    }
    @Nullable InetAddress address = NumericAddress.parse(host);
    return address != null && OwnAddresses.isAlwaysLocal(address) ? socket : null;
  }

  @Override
  public boolean checkTrustEquivalence(@Nullable Object other) {
    return other instanceof TransportEndpoint endpoint
        && equals(endpoint)
        && Objects.equals(endpoint.local, local);
  }

  /** Whether the other one leads to the same TCP port: the server may have been restarted there. */
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof TransportEndpoint endpoint
        && endpoint.host.equals(host)
        && endpoint.port == port;
  }

  @Override
  public int hashCode() {
    return 31 * host.hashCode() + port;
  }

  @Override
  public String toString() {
    return "TransportEndpoint[" + host + ":" + port + "]";
  }

  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    in.defaultReadObject();
    identity = CurrentIdentity.get();
    if (host == null || port < 1 || port > MAX_PORT || (path == null) != (computer == null)) {
      throw new InvalidObjectException("an endpoint of host " + host + " and port " + port);
    }
    if (path != null && computer != null) {
      Uuid server = UuidFactory.create(serverHigh, serverLow);
      try {
        local = new LocalSocket(computer, path, server);
      } catch (IllegalArgumentException e) {
        throw (InvalidObjectException) new InvalidObjectException(e.getMessage()).initCause(e);
      }
    }
  }
}
