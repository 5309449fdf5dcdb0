package org.dfra.drivers.device;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * The modules that share a link. Its reader thread notifies them; a removed module receives no more
 * notifications. Safe for use by several threads.
 *
 * @param <M> interface through which the protocol notifies and queries its clients
 */
public final class SharedLinkClients<M extends SharedLinkClient> {

  /** Held during notifications, so that a client that has left receives no more of them. */
  private final ReentrantLock dispatchLock = new ReentrantLock();

  @GuardedBy("dispatchLock")
  private final Set<M> clients = new LinkedHashSet<>();

  @GuardedBy("dispatchLock")
  private final Set<M> connected = new LinkedHashSet<>();

  void add(M client) {
    dispatchLock.lock();
    try {
      clients.add(client);
    } finally {
      dispatchLock.unlock();
    }
  }

  /**
   * Removes a client; returns when it will receive no more notifications.
   *
   * @return whether there is none left
   */
  boolean remove(M client) {
    dispatchLock.lock();
    try {
      clients.remove(client);
      connected.remove(client);
      return clients.isEmpty();
    } finally {
      dispatchLock.unlock();
    }
  }

  /** Notifies the clients that are not connected yet that there is a device. */
  public void notifyConnected(Consumer<M> action) {
    dispatchLock.lock();
    try {
      for (M member : new ArrayList<>(clients)) {
        if (connected.add(member)) {
          action.accept(member);
        }
      }
    } finally {
      dispatchLock.unlock();
    }
  }

  /** Notifies the connected clients. */
  public void dispatch(Consumer<M> action) {
    dispatchLock.lock();
    try {
      new ArrayList<>(connected).forEach(action);
    } finally {
      dispatchLock.unlock();
    }
  }

  /** Notifies all clients that the device is lost; they are not connected any more. */
  public void notifyLost(String reason) {
    dispatchLock.lock();
    try {
      connected.clear();
      new ArrayList<>(clients).forEach(member -> member.lost(reason));
    } finally {
      dispatchLock.unlock();
    }
  }

  /**
   * Queries all clients together.
   *
   * @param question must not keep the list
   */
  public <R> R query(Function<List<M>, R> question) {
    dispatchLock.lock();
    try {
      return question.apply(List.copyOf(clients));
    } finally {
      dispatchLock.unlock();
    }
  }
}
