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
 * One registered object of the daemon. If several callers activate it at once, one call
 * instantiates the object, and all receive the same proxy.
 */
final class ActivatableObject {

  private static final int ATTEMPTS = 2;

  /**
   * Attempts if a group's process proves unusable: the last one calls the process that replaces it.
   */
  private static final int WITH_REPLACEMENT = ATTEMPTS + 1;

  /** Shorter than the deadline of the calls that wait for the instantiation. */
  private static final Duration MAKING_AWAITED = Duration.ofSeconds(8);

  private static final long NEVER = -1;

  final UID uid;
  final ManagedGroup group;
  private final ReentrantLock lock = new ReentrantLock();
  private volatile ActivationDesc desc;
  private volatile @Nullable KnownProxy known;
  private volatile long inactiveIn = NEVER; // the incarnation that reported it last
  private volatile long madeIn = NEVER; // the last incarnation that was asked to instantiate it
  private volatile long workedIn = NEVER;
  private volatile boolean retired;

  /** The object's marshalled proxy. It is valid while the incarnation that supplied it runs. */
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
   * Returns the object's marshalled proxy; activates the object first if necessary.
   *
   * @param id the object's activation ID
   * @param force whether to call the group even if a proxy is known
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
        requireRegistered(); // else an unregistration might miss this instantiation
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
            e)) { // else it may be running, and this process has too many open files
          group.unusable(maker, true);
          attempts = WITH_REPLACEMENT;
        }
        last = e;
      } catch (RemoteException e) { // the object may have been instantiated
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
            + ") could not be created in "
            + attempts
            + " attempts: "
            + (last == null ? "" : last.getMessage()),
        last);
  }

  private void requireRegistered() throws UnknownObjectException {
    if (retired) {
      throw new UnknownObjectException("object " + uid + " was unregistered");
    }
  }

  private @Nullable MarshalledObject<? extends Remote> knownProxy() {
    @Nullable KnownProxy now = known;
    return now != null && group.isActive(now.incarnation()) ? now.proxy() : null;
  }

  /** Stores the proxy that the object's group reports. */
  void active(MarshalledObject<? extends Remote> proxy) {
    known = new KnownProxy(proxy, group.incarnation());
  }

  /** Records that the object's group reported it inactive. */
  void inactive() {
    inactiveIn = group.incarnation();
    madeIn = NEVER;
    known = null;
  }

  /** Records that it was ready for {@code minReadyTime} in an incarnation of its group. */
  void setStable(long incarnation) {
    workedIn = incarnation;
  }

  /** Whether {@link #setStable} was called for an incarnation of its group. */
  boolean wasStable(long incarnation) {
    return workedIn == incarnation;
  }

  /** Whether its latest known proxy belongs to an incarnation of its group. */
  boolean wasActive(long incarnation) {
    @Nullable KnownProxy now = known;
    return now != null && now.incarnation() == incarnation;
  }

  /**
   * Whether the object is active or may be. It is if its proxy is known and its group runs. It may
   * be if its group was adopted from an earlier phoenix, or has not yet answered an activation.
   */
  boolean mayBeActive() {
    return knownProxy() != null || isUnknown();
  }

  private boolean isUnknown() {
    return group.isActive(madeIn) || (group.isAdopted() && inactiveIn != group.incarnation());
  }

  /**
   * Returns the object's proxy if it is active, else null.
   *
   * @throws ActivationException if the instantiation takes too long
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
   * Prevents further instantiations, unless the object is active.
   *
   * @return whether it is retired now
   * @throws ActivationException if the instantiation takes too long
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

  /** Records that it was unregistered: threads that wait for its instantiation fail. */
  void retire() {
    retired = true;
  }

  /** Undoes {@link #retire}: the object remains registered. */
  void reactivate() {
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
            + ") is still being created after "
            + MAKING_AWAITED.toSeconds()
            + " s; call again");
  }
}
