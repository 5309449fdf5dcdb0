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
public final class LineMembers<M extends LineMember> {

  /** Held while members are told something, so that one that has left is told nothing more. */
  private final ReentrantLock telling = new ReentrantLock();

  private final Set<M> members = new LinkedHashSet<>(); // guarded by telling
  private final Set<M> greeted = new LinkedHashSet<>(); // guarded by telling

  void add(M member) {
    telling.lock();
    try {
      members.add(member);
    } finally {
      telling.unlock();
    }
  }

  /**
   * Returns when it will not be told anything any more.
   *
   * @return whether there is none left
   */
  boolean remove(M member) {
    telling.lock();
    try {
      members.remove(member);
      greeted.remove(member);
      return members.isEmpty();
    } finally {
      telling.unlock();
    }
  }

  /** Tells those who have joined, or lost their device, since that there is one. */
  public void greet(Consumer<M> hello) {
    telling.lock();
    try {
      for (M member : new ArrayList<>(members)) {
        if (greeted.add(member)) {
          hello.accept(member);
        }
      }
    } finally {
      telling.unlock();
    }
  }

  /** Tells something to those who were greeted. */
  public void tell(Consumer<M> what) {
    telling.lock();
    try {
      new ArrayList<>(greeted).forEach(what);
    } finally {
      telling.unlock();
    }
  }

  /** Tells all of them that there is no device any more; they are to be greeted again. */
  public void lose(String reason) {
    telling.lock();
    try {
      greeted.clear();
      new ArrayList<>(members).forEach(member -> member.lost(reason));
    } finally {
      telling.unlock();
    }
  }

  /**
   * Finds out what they want, all together.
   *
   * @param question must not keep the list
   */
  public <R> R ask(Function<List<M>, R> question) {
    telling.lock();
    try {
      return question.apply(List.copyOf(members));
    } finally {
      telling.unlock();
    }
  }
}
