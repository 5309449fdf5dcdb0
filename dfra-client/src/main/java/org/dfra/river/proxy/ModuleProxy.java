package org.dfra.river.proxy;

import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serializable;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import net.jini.admin.Administrable;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.ModuleLease;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.module.LogLevel;
import org.dfra.module.Module;
import org.dfra.module.ModuleHistory;
import org.dfra.module.Parameter;
import org.dfra.river.call.RobotAuthentication;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.remote.RemoteModule;
import org.jspecify.annotations.Nullable;

/**
 * Smart proxy of a module. It has the module's constants. It calls the implementation directly if
 * that runs in the same virtual machine, else the server.
 *
 * <p>A subclass has a public constructor with the arguments of {@link #ModuleProxy}, except the
 * kind.
 *
 * @param <M> the module's interface
 */
public abstract class ModuleProxy<M extends Module> implements Module, Administrable, Serializable {

  private static final long serialVersionUID = 1L;

  private final Class<M> kind;
  private RemoteModule server; // assigned once, when constructed or read
  private final UUID id;
  private final Identification identification;
  private transient @Nullable ChannelIdentity identity = CurrentIdentity.get(); // or when read

  /**
   * @param kind the module's interface
   * @param server the server's remote proxy; it must implement {@code kind} too
   * @param id the module's identity, its service ID in the lookup service
   * @param identification the module's identification
   */
  protected ModuleProxy(
      Class<M> kind, RemoteModule server, UUID id, Identification identification) {
    if (!kind.isInstance(server)) {
      throw new IllegalArgumentException(
          "the server of "
              + identification.path()
              + " is not of type "
              + kind.getSimpleName()
              + "; name in the module's properties a proxy class that fits the server class");
    }
    this.kind = kind;
    this.server = server;
    this.id = id;
    this.identification = identification;
  }

  /** The target of calls: a local implementation, else the server. */
  protected final M target() {
    @Nullable Module local = LocalModuleRegistry.find(id, identity);
    return kind.cast(local != null ? local : server);
  }

  @Override
  public final Identification identification() {
    return identification;
  }

  @Override
  public final Readiness readiness() throws RemoteException {
    return target().readiness();
  }

  @Override
  public final Readiness awaitReadiness(Duration patience) throws RemoteException {
    // A timeout that is too long becomes the longest; only differences are used, so it may wrap.
    long end = System.nanoTime() + TimeUnit.NANOSECONDS.convert(patience);
    while (true) {
      Duration left = Duration.ofNanos(Math.max(0, end - System.nanoTime()));
      Readiness readiness = target().awaitReadiness(left);
      if (readiness.serves() || readiness.isFailedOrStopped() || System.nanoTime() - end >= 0) {
        return readiness;
      }
    }
  }

  /**
   * {@inheritDoc}
   *
   * <p>If the module is remote, the listener is exported at {@link
   * org.dfra.river.call.CallbackHost} until the subscription is closed.
   */
  @Override
  public final Subscription subscribe(ModuleListener listener, DeliveryPolicy policy)
      throws RemoteException {
    @Nullable Module local = LocalModuleRegistry.find(id, identity);
    return local != null
        ? local.subscribe(listener, policy)
        : ProxySubscription.open(identification.path(), server, listener, policy, identity);
  }

  @Override
  public final ModuleLease acquireLease(Duration duration)
      throws LeaseRefusedException, RemoteException {
    @Nullable Module local = LocalModuleRegistry.find(id, identity);
    return local != null
        ? local.acquireLease(duration)
        : ProxyLease.open(identification.path(), server, duration);
  }

  @Override
  public final ModuleHistory history() throws RemoteException {
    return target().history();
  }

  @Override
  public final LogLevel logLevel() throws RemoteException {
    return target().logLevel();
  }

  @Override
  public final void setLogLevel(LogLevel level) throws RemoteException {
    target().setLogLevel(level);
  }

  @Override
  public final List<Parameter> parameters() throws RemoteException {
    return target().parameters();
  }

  @Override
  public final void setParameter(String name, String text) throws RemoteException {
    target().setParameter(name, text);
  }

  /** The module's {@link org.dfra.river.remote.ModuleAdmin}. */
  @Override
  public final Object getAdmin() throws RemoteException {
    return PreparedProxies.proxy(server, server.getAdmin());
  }

  /** The module's identity, its service ID in the lookup service. */
  public final UUID id() {
    return id;
  }

  /** The server's remote proxy, for functions that only remote clients need. */
  public final RemoteModule server() {
    return server;
  }

  @Override
  public final boolean equals(@Nullable Object other) {
    return other instanceof ModuleProxy<?> proxy && proxy.id.equals(id);
  }

  @Override
  public final int hashCode() {
    return id.hashCode();
  }

  @Override
  public final String toString() {
    return identification.path() + " (" + getClass().getSimpleName() + ")";
  }

  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    in.defaultReadObject();
    if (kind == null || id == null || identification == null || !kind.isInstance(server)) {
      throw new InvalidObjectException("a module proxy without kind, server, identity or name");
    }
    identity = CurrentIdentity.get();
    server = RobotAuthentication.require(identification.robot(), server);
  }
}
