package org.dfra.river.server;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.stream.LongStream;
import net.jini.core.lease.Lease;
import org.dfra.core.budget.BudgetExceededException;
import org.dfra.core.budget.ListenerShare;
import org.dfra.core.event.EventHub;
import org.dfra.core.module.ModuleImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleListener;
import org.dfra.event.delivery.BatchLimits;
import org.dfra.event.delivery.BatchListener;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.NotReadyException;
import org.dfra.river.call.CallbackProxies;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.callback.CallbackLimiter;
import org.dfra.river.callback.CallbackLimiter.CallbackSlot;
import org.dfra.river.callback.CallbackRefusedException;
import org.dfra.river.callback.ClientAddress;
import org.dfra.river.callback.PeerQuota;
import org.dfra.river.lease.ModuleLandlord;
import org.dfra.river.remote.GrantedSubscription;
import org.dfra.river.remote.RemoteModuleListener;
import org.dfra.river.security.SecureProcess;
import org.dfra.river.security.budget.ProcessBudgets;
import org.jspecify.annotations.Nullable;

/**
 * The remote listeners of one module. Each has a lease and an entry in the module's event hub. It
 * loses both when its client closes the subscription, when the lease has expired, when {@value
 * #FAILURES} calls in a row have failed, or when it no longer exists. A call that succeeds renews
 * the lease.
 *
 * <p>Each call delivers what waits in the listener's queue. It takes at most {@link
 * CallbackProxies#DEADLINE}, whatever deadline the listener's proxy has, on the executor of its
 * process. The number of a client's listeners is limited.
 */
final class RemoteListenerRegistry {

  /** At a deadline of 2 s each, this is six seconds without an answer. */
  private static final int FAILURES = 3;

  /**
   * Far below the limits of a call's arguments, of which one event may have nearly all; and so few
   * that a link on which one event takes long is not asked for many at once.
   */
  private static final BatchLimits BATCH =
      new BatchLimits(
          RemoteModuleListener.MAX_EVENTS, 32 << 10, CallbackProxies.DEADLINE.dividedBy(8));

  private static final PeerQuota.QuotaLimits LIMITS = new PeerQuota.QuotaLimits(128, 512, 1024);

  private final ModuleImpl driver;
  private final ModuleLandlord landlord;
  private final String host;
  private final PeerQuota quota;

  @GuardedBy("this")
  private final Map<ModuleListener, RegisteredListener> registered = new HashMap<>();

  /**
   * @param host address or name that the module's proxies carry
   */
  RemoteListenerRegistry(ModuleImpl driver, ModuleLandlord landlord, String host) {
    this.driver = driver;
    this.landlord = landlord;
    this.host = host;
    this.quota = new PeerQuota("listeners of " + driver.identification().path(), LIMITS);
  }

  /** One listener's lease and entries. */
  private static final class RegisteredListener {
    final ModuleListener listener;
    final ClientAddress client;
    boolean isCounted; // guarded by the listeners
    @Nullable ListenerShare share; // guarded by the listeners
    @Nullable CallbackSlot slot; // guarded by the listeners
    EventHub.@Nullable ListenerEntry entry; // guarded by the listeners
    @Nullable UUID lease; // guarded by the listeners

    RegisteredListener(ModuleListener listener, ClientAddress client) {
      this.listener = listener;
      this.client = client;
    }
  }

  synchronized GrantedSubscription add(ModuleListener listener, DeliveryPolicy policy) {
    if (!(listener instanceof RemoteModuleListener remote)) {
      throw new IllegalArgumentException(
          driver.identification().path()
              + " cannot notify a "
              + listener.getClass().getSimpleName()
              + ", which is not a RemoteModuleListener; subscribe through the module's proxy");
    }
    RegisteredListener before = registered.get(listener);
    if (before != null) {
      remove(before);
    }
    RegisteredListener now = new RegisteredListener(listener, ClientAddress.ofCurrentCall(host));
    try {
      return register(now, remote, policy);
    } catch (LeaseRefusedException | CallbackRefusedException | BudgetExceededException e) {
      remove(now);
      throw refused(String.valueOf(e.getMessage()));
    } catch (RuntimeException e) {
      remove(now);
      throw e;
    }
  }

  private NotReadyException refused(String reason) {
    return new NotReadyException(driver.identification().path(), driver.readiness(), reason);
  }

  @GuardedBy("this")
  private GrantedSubscription register(
      RegisteredListener now, RemoteModuleListener remote, DeliveryPolicy policy)
      throws LeaseRefusedException, CallbackRefusedException, BudgetExceededException {
    Optional<String> refusal = quota.acquire(now.client);
    if (refusal.isPresent()) {
      throw refused(refusal.get());
    }
    now.isCounted = true;
    ListenerShare share = BudgetedListener.admit(driver.identification().name()).orElse(null);
    now.share = share;
    CallbackSlot place = CallbackLimiter.shared().admit(now.client, remote);
    now.slot = place;
    Runnable gone = () -> remove(now); // also if the client cancels the lease
    Lease lease = landlord.grant(Lease.ANY, ModuleImpl.leaseRole(policy), gone, gone);
    UUID id = ModuleLandlord.id(lease);
    now.lease = id;
    EventHub.ListenerEntry entry =
        driver
            .events()
            .add(
                within(
                    share,
                    remote,
                    new ListenerCalls(
                        CallbackProxies.withDeadline(
                            remote, RemoteModuleListener.class, CallbackProxies.DEADLINE),
                        () -> driver.leases().prolong(id))),
                BATCH,
                policy,
                FAILURES,
                gone,
                place.lane());
    now.entry = entry;
    registered.put(now.listener, now);
    return new GrantedSubscription(
        lease, entry.epoch(), LongStream.of(entry.lastSequences()).boxed().toList());
  }

  /** The calls to a listener, within its budgets if there are any. */
  private BatchListener within(
      @Nullable ListenerShare share, RemoteModuleListener remote, BatchListener calls) {
    Optional<ProcessBudgets> budgets = SecureProcess.budgets();
    if (share == null || budgets.isEmpty()) {
      return calls;
    }
    @Nullable PeerAddress to = PeerAddress.of(remote);
    boolean isOnRadio = to == null || BudgetedListener.leavesComputer(to.host(), host);
    ProcessBudgets process = budgets.get();
    return new BudgetedListener(
        calls,
        share,
        isOnRadio ? () -> process.oneIn(share.priority()) : () -> 1,
        process::countThinned,
        System::nanoTime);
  }

  /** Also for one that is being removed: ending its lease calls this again, without effect. */
  private synchronized void remove(RegisteredListener gone) {
    boolean unused = registered.remove(gone.listener, gone);
    if (gone.entry != null) {
      driver.events().remove(gone.entry);
    }
    if (gone.share != null) {
      gone.share.close();
    }
    if (gone.slot != null) {
      gone.slot.close();
    }
    if (gone.isCounted) {
      gone.isCounted = false;
      quota.release(gone.client);
    }
    if (gone.lease != null) {
      boolean ended = driver.leases().cancel(gone.lease);
    }
  }
}
