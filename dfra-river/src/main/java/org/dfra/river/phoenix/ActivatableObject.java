package org.dfra.river.phoenix;

import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.MarshalledObject;
import java.rmi.NoSuchObjectException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownObjectException;
import java.rmi.server.UID;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import org.dfra.river.call.ConnectionRefusal;
import org.dfra.river.phoenix.ManagedGroup.ActiveInstantiator;
import org.jspecify.annotations.Nullable;

/**
 * One registered object as the daemon sees it. However many callers want it activated, one of them
 * has it made and the others get the same proxy.
 */
final class ActivatableObject {

  private static final int ATTEMPTS = 2;

  /** Where a group's process turned out to be unusable: the one that replaces it is asked too. */
  private static final int WITH_REPLACEMENT = ATTEMPTS + 1;

  /** Shorter than the deadline of the calls that wait for it. */
  private static final Duration MAKING_AWAITED = Duration.ofSeconds(8);

  private static final long NEVER = -1;

  final UID uid;
  final ManagedGroup group;
  private final ReentrantLock lock = new ReentrantLock();
  private volatile ActivationDesc desc;
  private volatile @Nullable KnownProxy known;
  private volatile long inactiveIn = NEVER; // the incarnation that said so last
  private volatile long madeIn = NEVER; // the incarnation that was asked for it last, and may
  private volatile long workedIn = NEVER;
  private volatile boolean retired;

  /** The object's marshalled proxy, good as long as the incarnation that gave it works. */
  private record KnownProxy(MarshalledObject<? extends Remote> proxy, long incarnation) {}

  ActivatableObject(UID uid, ManagedGroup group, ActivationDesc desc) {
    this.uid = uid;
    this.group = group;
    this.desc = desc;
  }

  ActivationDesc desc() {
    return desc;
  }

  void setDesc(ActivationDesc next) {
    desc = next;
  }

  /**
   * The object's marshalled proxy.
   *
   * @param id the object's activation ID
   * @param force whether to ask the group even if a proxy is known
   */
  MarshalledObject<? extends Remote> activate(ActivationID id, boolean force)
      throws ActivationException {
    if (!force) {
      @Nullable MarshalledObject<? extends Remote> proxy = knownProxy();
      if (proxy != null) {
        return proxy;
      }
    }
    lock.lock();
    try {
      @Nullable MarshalledObject<? extends Remote> proxy = force ? null : knownProxy();
      return proxy != null ? proxy : make(id);
    } finally {
      lock.unlock();
    }
  }

  private MarshalledObject<? extends Remote> make(ActivationID id) throws ActivationException {
    @Nullable Exception last = null;
    int attempts = ATTEMPTS;
    for (int attempt = 1; attempt <= attempts; attempt++) {
      requireRegistered();
      ActiveInstantiator maker = group.awaitInstantiator();
      madeIn = maker.incarnation();
      try {
        requireRegistered(); // else whoever unregisters it now finds that it is being made
        MarshalledObject<? extends Remote> proxy = maker.instantiator().newInstance(id, desc);
        known = new KnownProxy(proxy, maker.incarnation());
        return proxy;
      } catch (NoSuchObjectException | InactiveGroupException e) {
        madeIn = NEVER;
        group.unusable(maker, false);
        attempts = WITH_REPLACEMENT;
        last = e;
      } catch (ConnectException | ConnectIOException e) {
        madeIn = NEVER;
        if (ConnectionRefusal.isProvenBy(
            e)) { // else it may work, and this process have too many open files
          group.unusable(maker, true);
          attempts = WITH_REPLACEMENT;
        }
        last = e;
      } catch (RemoteException e) { // it may have been made
        last = e;
      } catch (ActivationException e) {
        madeIn = NEVER;
        throw e;
      }
    }
    throw new ActivationException(
        "an object of group "
            + group.name
            + " ("
            + desc.getClassName()
            + ") could not be made in "
            + attempts
            + " attempts: "
            + (last == null ? "" : last.getMessage()),
        last);
  }

  private void requireRegistered() throws UnknownObjectException {
    if (retired) {
      throw new UnknownObjectException("the object was unregistered");
    }
  }

  private @Nullable MarshalledObject<? extends Remote> knownProxy() {
    @Nullable KnownProxy now = known;
    return now != null && group.isActive(now.incarnation()) ? now.proxy() : null;
  }

  /** The object's group tells its proxy. */
  void active(MarshalledObject<? extends Remote> proxy) {
    known = new KnownProxy(proxy, group.incarnation());
  }

  /** The object's group says that it is not active any more. */
  void inactive() {
    inactiveIn = group.incarnation();
    madeIn = NEVER;
    known = null;
  }

  /** It has been ready in an incarnation of its group for as long as the restart policy wants. */
  void setStable(long incarnation) {
    workedIn = incarnation;
  }

  /** Whether it has {@link #setStable worked} in an incarnation of its group. */
  boolean wasStable(long incarnation) {
    return workedIn == incarnation;
  }

  /** Whether it was active in an incarnation of its group, at last. */
  boolean wasActive(long incarnation) {
    @Nullable KnownProxy now = known;
    return now != null && now.incarnation() == incarnation;
  }

  /**
   * Whether its proxy is known and its group works, or nobody knows: its group works since before
   * this phoenix did, or was asked for the object and has not answered.
   */
  boolean mayBeActive() {
    return knownProxy() != null || isUnknown();
  }

  private boolean isUnknown() {
    return group.isActive(madeIn) || (group.isAdopted() && inactiveIn != group.incarnation());
  }

  /**
   * The object's proxy where it is active; null where it is not.
   *
   * @throws ActivationException if it takes too long to be made
   */
  @Nullable MarshalledObject<? extends Remote> activeProxy(ActivationID id)
      throws ActivationException {
    awaitMade();
    try {
      @Nullable MarshalledObject<? extends Remote> proxy = knownProxy();
      return proxy == null && isUnknown() ? make(id) : proxy;
    } finally {
      lock.unlock();
    }
  }

  /**
   * Has nobody make it any more, unless it is active.
   *
   * @return whether it is retired now
   * @throws ActivationException if it takes too long to be made
   */
  boolean retireUnlessActive() throws ActivationException {
    awaitMade();
    try {
      retired = !mayBeActive();
      return retired;
    } finally {
      lock.unlock();
    }
  }

  /** It was unregistered: whoever waits to have it made does not get it. */
  void retire() {
    retired = true;
  }

  /** Its registration stays after all. */
  void unretire() {
    retired = false;
  }

  private void awaitMade() throws ActivationException {
    try {
      if (lock.tryLock(MAKING_AWAITED.toMillis(), TimeUnit.MILLISECONDS)) {
        return;
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    throw new ActivationException(
        "an object of group "
            + group.name
            + " ("
            + desc.getClassName()
            + ") is still being made after "
            + MAKING_AWAITED.toSeconds()
            + " s; ask again");
  }
}
