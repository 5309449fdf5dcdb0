package org.dfra.river.proxy;

import java.io.IOException;
import java.rmi.ConnectIOException;
import java.rmi.RemoteException;
import java.time.Instant;
import java.util.EnumSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import net.jini.core.lease.Lease;
import net.jini.export.Exporter;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.event.delivery.DeliveryCounter;
import org.dfra.event.delivery.DeliveryPool;
import org.dfra.event.delivery.ListenerQueue;
import org.dfra.river.call.CallbackHost;
import org.dfra.river.call.DeadlineExceededException;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.remote.DeliveryList;
import org.dfra.river.remote.GrantedSubscription;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.remote.RemoteModuleListener;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * A local listener's subscription to a remote module.
 *
 * <pre>
 *   server --&gt; this (exported) --&gt; ListenerQueue --&gt; DeliveryCounter --&gt; listener
 * </pre>
 *
 * <p>The server's call ends when the event is queued, so a slow listener does not delay it.
 */
final class ProxySubscription implements RemoteModuleListener, Subscription {

  /** JERI holds what it exports weakly, so open subscriptions are referenced here. */
  private static final Set<ProxySubscription> OPEN = ConcurrentHashMap.newKeySet();

  private final DeliveryCounter counter;
  private final ListenerQueue queue;
  private final Exporter exporter;
  private final DeliveryRenewals renewals = new DeliveryRenewals();
  private volatile @Nullable LeaseRenewer renewer; // set before open returns

  private ProxySubscription(Exporter exporter, ModuleListener listener, DeliveryPolicy policy) {
    this.exporter = exporter;
    this.counter = new DeliveryCounter(listener);
    // The server has applied the kinds and the rate; here the queue only limits waiting events.
    this.queue =
        new ListenerQueue(
            counter,
            new DeliveryPolicy(
                EnumSet.allOf(DeliveryPolicy.EventKind.class),
                policy.queueDepth(),
                Double.POSITIVE_INFINITY),
            ListenerQueue.NEVER_GIVE_UP,
            () -> {},
            DeliveryPool.shared(),
            Scheduler.system());
  }

  /**
   * Subscribes.
   *
   * @param path the module's path, for the log
   * @param identity with which the listener is exported
   * @throws RemoteException if the server cannot be reached, or cannot reach this client
   */
  static ProxySubscription open(
      String path,
      RemoteModule server,
      ModuleListener listener,
      DeliveryPolicy policy,
      @Nullable ChannelIdentity identity)
      throws RemoteException {
    if (identity != null && identity != CurrentIdentity.get()) {
      return CurrentIdentity.callAs(identity, () -> open(path, server, listener, policy, identity));
    }
    ProxySubscription subscription =
        new ProxySubscription(
            JeriExporters.notKeepingAlive(Endpoints.tcp(host(server), 0), new DeadlineILFactory()),
            listener,
            policy);
    subscription.register(path, server, policy);
    subscription.renewer().start();
    return subscription;
  }

  private void register(String path, RemoteModule server, DeliveryPolicy policy)
      throws RemoteException {
    ModuleListener stub = (ModuleListener) exporter.export(this);
    OPEN.add(this);
    try {
      long asked = Scheduler.system().nanos();
      GrantedSubscription first = registerFirst(server, stub, policy);
      renewer =
          new LeaseRenewer(
                  "subscription to " + path,
                  () -> PreparedProxies.lease(server, register(server, stub, policy).lease()),
                  Lease.ANY,
                  PreparedProxies.lease(server, first.lease()),
                  Scheduler.system())
              .requestedAt(asked);
    } catch (RemoteException | RuntimeException e) {
      unexport();
      throw e;
    }
  }

  private LeaseRenewer renewer() {
    return Objects.requireNonNull(renewer);
  }

  private static String host(RemoteModule server) throws RemoteException {
    try {
      return CallbackHost.addressReachableFrom(server);
    } catch (IOException e) {
      throw new ConnectIOException(
          "this machine finds no way to the server; name its own address with -D"
              + CallbackHost.PROPERTY,
          e);
    }
  }

  /**
   * Registers once more if the answer is late, as that of a busy computer's first call: the server
   * replaces a listener that it has already.
   */
  private GrantedSubscription registerFirst(
      RemoteModule server, ModuleListener stub, DeliveryPolicy policy) throws RemoteException {
    try {
      return register(server, stub, policy);
    } catch (DeadlineExceededException e) {
      return register(server, stub, policy);
    }
  }

  private GrantedSubscription register(
      RemoteModule server, ModuleListener stub, DeliveryPolicy policy) throws RemoteException {
    if (server.subscribe(stub, policy) instanceof GrantedSubscription leased) {
      counter.startAfter(leased.sequenceNumbers().stream().mapToLong(Long::longValue).toArray());
      return leased;
    }
    throw new RemoteException("the server gave no lease for the listener");
  }

  /** Receives an event that is not from the server's subscription. */
  @Override
  public void notify(Delivery delivery) {
    queue.offer(delivery);
  }

  /** Receives an event from the server. */
  @Override
  public void notify(Delivery delivery, long call, long renewed) {
    received(call, renewed);
    queue.offer(delivery);
  }

  /** Receives events from the server. Each goes to the listener for itself. */
  @Override
  public void notify(List<Delivery> deliveries, long call, long renewed) {
    List<Delivery> checked = DeliveryList.checked(deliveries);
    received(call, renewed);
    checked.forEach(queue::offer);
  }

  private void received(long call, long renewed) {
    OptionalLong proof = renewals.received(call, renewed, Scheduler.system().nanos());
    @Nullable LeaseRenewer open = renewer;
    if (proof.isPresent() && open != null) {
      open.renewedByPeer(proof.getAsLong());
    }
  }

  @Override
  public long received() {
    return counter.received();
  }

  @Override
  public long lost() {
    return counter.lost();
  }

  @Override
  public Optional<Instant> interruptedSince() {
    return renewer().interruptedSince();
  }

  @Override
  public boolean isOpen() {
    return !renewer().isClosed();
  }

  @Override
  public void close() {
    renewer().close();
    queue.close();
    unexport();
  }

  private void unexport() {
    boolean unused = exporter.unexport(true);
    OPEN.remove(this);
  }
}
