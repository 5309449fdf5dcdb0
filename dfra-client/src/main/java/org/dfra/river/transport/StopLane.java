package org.dfra.river.transport;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import com.sun.jini.jeri.internal.runtime.Util;
import java.lang.reflect.Method;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import org.dfra.river.identity.ChannelPeer;
import org.dfra.river.transport.Block.Kind;
import org.dfra.security.Caller;
import org.jspecify.annotations.Nullable;

/**
 * What is kept for emergency stops when everything else of this virtual machine is in use: threads
 * for calls, and connections with a thread for their handshakes. A connection is for a stop if its
 * greeting says so, and a call if it begins with the number of such a method. Either may be a lie,
 * so nobody gets much. Thread-safe.
 */
public final class StopLane {

  /** The most calls at once of one member, and of strangers at one address. */
  static final int CALLS_OF_CALLER = 4;

  /** The most calls of all members at once. */
  static final int CALLS = 64;

  /** The most calls of all strangers at once: a closed robot does not know its members. */
  static final int CALLS_OF_STRANGERS = 16;

  /** The most new connections of one address that are preferred at once. */
  static final int CONNECTIONS_OF_ADDRESS = 8;

  /** The most new connections that are preferred at once. */
  static final int CONNECTIONS = 128;

  /** Within this time, a connection makes its first call. */
  static final long FIRST_CALL_NANOS = TimeUnit.SECONDS.toNanos(4);

  /**
   * Where a request has the number of its method: behind the header of its block, the ID of the
   * object (16 bytes), the version and the integrity of JERI's format, and the header of the object
   * stream with that of its first block.
   */
  private static final int METHOD_AT = Block.HEADER_BYTES + 16 + 2 + 4 + 2;

  private static final Set<Long> METHODS = ConcurrentHashMap.newKeySet();

  @GuardedBy("this")
  private final Map<Object, Integer> used = new HashMap<>(); // by caller

  @GuardedBy("this")
  private int ofMembers;

  @GuardedBy("this")
  private int ofStrangers;

  StopLane() {}

  /** Keeps capacity for the calls of a remote method, of whatever object. */
  public static void add(Method method) {
    METHODS.add(Util.getMethodHash(method));
  }

  /**
   * Whether a request that has arrived as a whole is for such a method.
   *
   * @param received ready to be read from
   */
  static boolean isStop(ByteBuffer received) {
    int at = received.position();
    if (received.remaining() < METHOD_AT + Long.BYTES) {
      return false;
    }
    int header = received.getInt(at);
    return header >>> 24 == Kind.END.ordinal()
        && received.remaining() >= Block.HEADER_BYTES + (header & 0xffffff)
        && METHODS.contains(received.getLong(at + METHOD_AT));
  }

  /** Whose share a connection uses, and whether that is a member. */
  record Share(Object caller, boolean isMember) {

    static Share of(Link link) {
      @Nullable ChannelPeer partner = link.partner();
      @Nullable Caller caller = partner == null ? null : partner.caller();
      return caller == null || caller.member().isEmpty()
          ? new Share(link.peer().origin(), false)
          : new Share(caller.member().get(), true);
    }
  }

  /** Takes a thread. Returns false if there is none for this caller. */
  synchronized boolean take(Share share) {
    int its = used.getOrDefault(share, 0);
    boolean isFree =
        its < CALLS_OF_CALLER
            && (share.isMember() ? ofMembers < CALLS : ofStrangers < CALLS_OF_STRANGERS);
    if (isFree) {
      used.put(share, its + 1);
      count(share, 1);
    }
    return isFree;
  }

  /** Gives it back. */
  synchronized void giveBack(Share share) {
    used.compute(share, (key, its) -> its == null || its == 1 ? null : its - 1);
    count(share, -1);
  }

  @GuardedBy("this")
  private void count(Share share, int change) {
    if (share.isMember()) {
      ofMembers += change;
    } else {
      ofStrangers += change;
    }
  }

  /**
   * Whether a further connection is preferred.
   *
   * @param connections all that there are
   */
  static boolean hasPlace(Iterable<ServerConnection> connections, Peer peer, long now) {
    int all = 0;
    int its = 0;
    for (ServerConnection each : connections) {
      if (each.isPreferred(now)) {
        all++;
        its += each.link().peer().origin().equals(peer.origin()) ? 1 : 0;
      }
    }
    return all < CONNECTIONS && its < CONNECTIONS_OF_ADDRESS;
  }
}
