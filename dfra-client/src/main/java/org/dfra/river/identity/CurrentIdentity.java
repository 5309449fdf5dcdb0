package org.dfra.river.identity;

import net.jini.core.constraint.InvocationConstraints;
import org.jspecify.annotations.Nullable;

/**
 * The identity that endpoints get when they are made or received: that of the thread if it has one,
 * otherwise that of the process. Calls leave on many threads, so it is not looked up for each call.
 */
public final class CurrentIdentity {

  private static final ThreadLocal<@Nullable ChannelIdentity> OF_THREAD = new ThreadLocal<>();

  private static volatile @Nullable ChannelIdentity ofProcess;

  private CurrentIdentity() {}

  /**
   * What runs with an identity.
   *
   * @param <T> its result
   * @param <E> what it throws
   */
  @FunctionalInterface
  public interface Body<T extends @Nullable Object, E extends Exception> {

    /** Runs. */
    T call() throws E;
  }

  /** The identity for a new endpoint; null if its calls are not encrypted. */
  public static @Nullable ChannelIdentity get() {
    @Nullable ChannelIdentity own = OF_THREAD.get();
    return own == null ? ofProcess : own;
  }

  /** Whether what this thread exports is encrypted, and nothing else may be exported. */
  public static boolean isSecure() {
    return get() != null;
  }

  /**
   * What a connection of this thread to a robot must have, so that nobody else answers in its name.
   *
   * @param name of the robot
   * @return no constraints if this program has joined no team
   */
  public static InvocationConstraints requiredOfRobot(String name) {
    @Nullable ChannelIdentity identity = get();
    return identity == null ? InvocationConstraints.EMPTY : identity.requiredOfRobot(name);
  }

  /**
   * Calls back when others may have lost a right towards the current identity: after each new list
   * of revoked certificates, and after each new policy. Without an identity there is none.
   *
   * @param listener must not wait
   * @return ends it
   */
  public static Runnable onLostRights(Runnable listener) {
    @Nullable ChannelIdentity identity = get();
    if (identity == null) {
      return () -> {};
    }
    identity.addRevocationListener(listener);
    Runnable notReplaced = identity.guard().permissions().onReplacement(listener);
    return () -> {
      identity.removeRevocationListener(listener);
      notReplaced.run();
    };
  }

  /**
   * Sets the identity of the process, before it makes or receives an endpoint. It cannot be taken
   * away again: nothing falls back to calls without encryption.
   *
   * @throws IllegalStateException if the process has another one
   */
  public static synchronized void setForProcess(ChannelIdentity identity) {
    if (ofProcess != null && ofProcess != identity) {
      throw new IllegalStateException("this process already has the identity " + ofProcess);
    }
    ofProcess = identity;
  }

  /**
   * Serves a call: the endpoints among its arguments get the identity of the called object, not
   * that of the process, which may have none or be another robot's.
   *
   * @param identity of the called object's port; null if its calls are not encrypted
   */
  public static void runAs(@Nullable ChannelIdentity identity, Runnable body) {
    @Nullable ChannelIdentity before = OF_THREAD.get();
    if (identity == null || identity == before || (before == null && identity == ofProcess)) {
      body.run();
      return;
    }
    OF_THREAD.set(identity);
    try {
      body.run();
    } finally {
      restore(before);
    }
  }

  /** What makes a call. */
  @FunctionalInterface
  public interface Call {

    /** Calls. */
    @Nullable Object run() throws Throwable;
  }

  /**
   * Makes a call: the endpoints in its answer get the identity with which it was made.
   *
   * @param identity of the called endpoint; null if its calls are not encrypted
   * @return the result
   */
  public static @Nullable Object callWith(@Nullable ChannelIdentity identity, Call call)
      throws Throwable {
    @Nullable ChannelIdentity before = OF_THREAD.get();
    if (identity == null || identity == before || (before == null && identity == ofProcess)) {
      return call.run();
    }
    OF_THREAD.set(identity);
    try {
      return call.run();
    } finally {
      restore(before);
    }
  }

  private static void restore(@Nullable ChannelIdentity before) {
    if (before == null) {
      OF_THREAD.remove();
    } else {
      OF_THREAD.set(before);
    }
  }

  /**
   * Runs with an identity: for robots that share a virtual machine.
   *
   * @return the result
   */
  public static <T extends @Nullable Object, E extends Exception> T callAs(
      ChannelIdentity identity, Body<T, E> body) throws E {
    @Nullable ChannelIdentity before = OF_THREAD.get();
    OF_THREAD.set(identity);
    try {
      return body.call();
    } finally {
      restore(before);
    }
  }

  /**
   * Runs as a program that has joined no team: what it calls is encrypted, and neither side knows
   * who the other is. Only for calls that are safe in all hands, such as a stop.
   *
   * @return the result
   */
  public static <T extends @Nullable Object, E extends Exception> T callAsStranger(Body<T, E> body)
      throws E {
    return callAs(AnonymousIdentity.instance(), body);
  }

  /** The identity that is current now, for work that other threads do later. */
  public static Kept keep() {
    return new Kept(OF_THREAD.get());
  }

  /** An identity of a thread; none if it had only that of the process. */
  public static final class Kept {

    private final @Nullable ChannelIdentity identity;

    private Kept(@Nullable ChannelIdentity identity) {
      this.identity = identity;
    }

    /** The same task with it, for a thread that has none of its own. */
    public Runnable wrap(Runnable task) {
      return identity == null ? task : () -> runAs(identity, task);
    }

    /** Runs with it. */
    public <T extends @Nullable Object, E extends Exception> T call(Body<T, E> body) throws E {
      return identity == null ? body.call() : callAs(identity, body);
    }
  }
}
