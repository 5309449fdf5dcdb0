package org.dfra.river.loading;

import java.util.HashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The digests that an authenticated peer vouches for while one of its messages is read.
 *
 * <p>A secure endpoint opens a scope around the reading of a call's arguments or result. First it
 * must know the peer's identity, that this peer may supply code, and that the connection is
 * protected against changes. It passes on only the codebase annotations of that stream, not those
 * of marshalled objects in it, which are third-party data:
 *
 * <pre>
 *   try (var scope = AuthenticatedDigests.open(principal)) {
 *     scope.vouch(annotation); // in readAnnotation() of the stream
 *     ...                      // resolveClass() calls the class provider in this thread
 *   }
 * </pre>
 *
 * <p>Plain TCP does not authenticate the peer and must never open a scope. A scope belongs to the
 * thread that opened it; an inner scope hides the outer one until it is closed.
 */
final class AuthenticatedDigests {

  private static final ThreadLocal<@Nullable Scope> CURRENT = new ThreadLocal<>();

  private AuthenticatedDigests() {}

  /**
   * Opens a scope in this thread, without any digests yet.
   *
   * @param peer its identity, for the log
   */
  static Scope open(String peer) {
    Scope scope = new Scope(peer, CURRENT.get());
    CURRENT.set(scope);
    return scope;
  }

  /** The peer that vouches for a digest in this thread now, or null if there is none. */
  static @Nullable String authenticator(String digest) {
    Scope scope = CURRENT.get();
    return scope != null && scope.digests.contains(digest) ? scope.peer : null;
  }

  /** The digests that one peer vouches for, until the scope is closed. */
  static final class Scope implements AutoCloseable {

    private final String peer;
    private final @Nullable Scope outer;
    private final Thread owner = Thread.currentThread();
    private final Set<String> digests = new HashSet<>();

    private Scope(String peer, @Nullable Scope outer) {
      this.peer = peer;
      this.outer = outer;
    }

    /**
     * Adds every digest of a codebase annotation.
     *
     * @throws CodeRefusedException if it is not of the form {@code httpmd:…;sha-256=…}
     * @throws IllegalStateException in another thread, or when the scope is closed or hidden
     */
    void authenticate(String codebase) {
      checkCurrent();
      CodebaseUrl.parse(codebase).forEach(url -> digests.add(url.digest()));
    }

    /** Withdraws the digests. Code that was loaded meanwhile stays loaded. */
    @Override
    public void close() {
      checkCurrent();
      if (outer == null) {
        CURRENT.remove();
      } else {
        CURRENT.set(outer);
      }
    }

    private void checkCurrent() {
      if (CURRENT.get() != this) {
        throw new IllegalStateException(
            "the scope of "
                + peer
                + " was opened in "
                + owner.getName()
                + " and is not the innermost open one in "
                + Thread.currentThread().getName());
      }
    }
  }
}
