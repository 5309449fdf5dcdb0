package org.dfra.drivers.device;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * The modules that share a line. They are told things by its reader thread; one that has been
 * removed is told nothing more. Safe for use by several threads.
 *
 * @param <M> what its protocol tells them and asks of them
 */
public final class SharedLinkClients<M extends SharedLinkClient> {

  /** Held while members are told something, so that one that has left is told nothing more. */
  private final ReentrantLock dispatchLock = new ReentrantLock();

  private final Set<M> clients = new LinkedHashSet<>(); // guarded by telling
  private final Set<M> connected = new LinkedHashSet<>(); // guarded by telling

  void add(M client) {
    dispatchLock.lock();
    try {
      clients.add(client);
    } finally {
      dispatchLock.unlock();
    }
  }

  /**
   * Returns when it will not be told anything any more.
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

  /** Tells those who have joined, or lost their device, since that there is one. */
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

  /** Tells something to those who were greeted. */
  public void dispatch(Consumer<M> action) {
    dispatchLock.lock();
    try {
      new ArrayList<>(connected).forEach(action);
    } finally {
      dispatchLock.unlock();
    }
  }

  /** Tells all of them that there is no device any more; they are to be greeted again. */
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
   * Finds out what they want, all together.
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
