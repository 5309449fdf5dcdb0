package org.dfra.river.call;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.LongSupplier;
import org.dfra.river.access.Caller;
import org.jspecify.annotations.Nullable;

/**
 * The addresses of hosts that endpoints from elsewhere name. A peer chooses the name, and with it
 * the name server that is asked, which may take minutes to answer; nothing ends a look-up. So it
 * waits on a thread of its own, and who asks for the address waits until a deadline at most.
 *
 * <pre>
 *   not known --look-up--&gt; known, looked up again after {@link #KNOWN_FOR}, beside the calls
 *       '------ fails ------&gt; not known, looked up again with the next call
 * </pre>
 *
 * <p>What was found counts until another answer comes, so names of peers that were called before
 * are known also while others keep all look-ups busy. The {@value #REMEMBERED} names that were
 * asked for last are kept.
 *
 * <p>Thread-safe. Threads: daemons {@code dfra-names-}, one for each look-up under way, {@value
 * #AT_ONCE} at most.
 */
final class PeerNames {

  /** Looks a name up; may wait for the network. */
  @FunctionalInterface
  interface Resolver {
    InetAddress resolve(String name) throws UnknownHostException;
  }

  /** Look-ups under way; further names are refused until one has ended. */
  static final int AT_ONCE = 16;

  static final Duration KNOWN_FOR = Duration.ofMinutes(1);

  private static final int REMEMBERED = 256;

  private static final PeerNames SHARED =
      new PeerNames(InetAddress::getByName, System::nanoTime, CallThreads.pool("dfra-names-"));

  private record Known(InetAddress address, long at) {}

  private final Resolver resolver;
  private final LongSupplier nanos;
  private final Executor executor;
  private final Map<String, FutureTask<InetAddress>> underWay = new HashMap<>(); // guarded by this

  private final Map<String, Known> known = // guarded by this
      new LinkedHashMap<>(16, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Known> eldest) {
          return size() > REMEMBERED;
        }
      };

  /**
   * @param nanos monotonic time
   * @param executor where look-ups wait
   */
  PeerNames(Resolver resolver, LongSupplier nanos, Executor executor) {
    this.resolver = resolver;
    this.nanos = nanos;
    this.executor = executor;
  }

  /** Those of this virtual machine, by this computer's resolver. */
  static PeerNames shared() {
    return SHARED;
  }

  /** Whether it has to be looked up: it is no address in digits. */
  static boolean isName(String host) {
    return Caller.at(host).address() == null;
  }

  /**
   * The address of a host.
   *
   * @param millis how long the look-up is awaited, where nothing is known yet
   * @param call what needs it, for people
   * @throws DeadlineExceededException if the look-up takes longer, or too many are under way
   * @throws java.rmi.UnknownHostException if there is no such host
   * @throws CallInterruptedException if this thread is interrupted; it stays so
   */
  InetAddress address(String name, long millis, String call) throws RemoteException {
    FutureTask<InetAddress> lookUp;
    synchronized (this) {
      Known before = known.get(name);
      if (before != null) {
        refresh(name, before);
        return before.address();
      }
      lookUp = lookUp(name, call);
    }
    try {
      return lookUp.get(millis, TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      throw new DeadlineExceededException(
          call + ", whose host is looked up,", Duration.ofMillis(millis), false);
    } catch (ExecutionException e) {
      throw new java.rmi.UnknownHostException("the host of " + call + " is not known", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CallInterruptedException(call, false);
    }
  }

  private synchronized void refresh(String name, Known before) {
    if (nanos.getAsLong() - before.at() >= KNOWN_FOR.toNanos()
        && !underWay.containsKey(name)
        && underWay.size() < AT_ONCE) {
      FutureTask<InetAddress> unused = begin(name);
    }
  }

  private synchronized FutureTask<InetAddress> lookUp(String name, String call)
      throws DeadlineExceededException {
    FutureTask<InetAddress> begun = underWay.get(name);
    if (begun != null) {
      return begun;
    }
    if (underWay.size() >= AT_ONCE) {
      throw new DeadlineExceededException(
          call
              + " was not tried: the look-ups of "
              + underWay.size()
              + " other hosts still hang; export at an address instead of a name");
    }
    return begin(name);
  }

  private synchronized FutureTask<InetAddress> begin(String name) {
    FutureTask<InetAddress> lookUp = new FutureTask<>(() -> resolve(name));
    underWay.put(name, lookUp);
    boolean isBegun = false;
    try {
      executor.execute(lookUp);
      isBegun = true;
    } finally {
      if (!isBegun) { // no thread can be started
        underWay.remove(name);
      }
    }
    return lookUp;
  }

  private InetAddress resolve(String name) throws UnknownHostException {
    @Nullable InetAddress found = null;
    try {
      found = resolver.resolve(name);
      return found;
    } finally {
      ended(name, found);
    }
  }

  private synchronized void ended(String name, @Nullable InetAddress found) {
    underWay.remove(name);
    if (found != null) {
      known.put(name, new Known(found, nanos.getAsLong()));
    }
  }
}
