package org.dfra.river.transport;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import org.dfra.river.access.NumericAddress;
import org.jspecify.annotations.Nullable;

/**
 * Resolves host names. A name service may not answer for long, and Java cannot interrupt the
 * question. So a name is asked for on a thread of its own, one for each name, and a caller can give
 * up waiting. Numeric addresses need none.
 */
final class HostAddresses {

  /** Each has a thread; approximate where several callers begin at once. */
  private static final int MAX_QUESTIONS = 32;

  private static final ConcurrentHashMap<String, CompletableFuture<InetAddress>> ASKED =
      new ConcurrentHashMap<>();

  private HostAddresses() {}

  /**
   * The first address of a host.
   *
   * @throws IOException if it is unknown, or the current call was abandoned
   */
  static InetAddress resolve(String host) throws IOException {
    @Nullable InetAddress numeric = NumericAddress.parse(host);
    if (numeric != null) {
      return numeric;
    }
    if (!ASKED.containsKey(host) && ASKED.size() >= MAX_QUESTIONS) {
      throw new IOException(
          "host " + host + " is not resolved: the answers for " + ASKED.size() + " others are due");
    }
    CompletableFuture<InetAddress> answer = ASKED.computeIfAbsent(host, HostAddresses::ask);
    CompletableFuture<InetAddress> waiting = answer.copy();
    CallInFlight.attachAttempt(() -> waiting.cancel(false));
    try {
      return waiting.get();
    } catch (ExecutionException e) {
      if (e.getCause() instanceof IOException unknown) {
        throw unknown;
      }
      throw new IOException("host " + host + " cannot be resolved", e.getCause());
    } catch (CancellationException e) {
      throw new IOException("the call was given up before host " + host + " was resolved", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("interrupted while host " + host + " was resolved");
    }
  }

  private static CompletableFuture<InetAddress> ask(String host) {
    CompletableFuture<InetAddress> answer = new CompletableFuture<>();
    Thread thread =
        new Thread(
            () -> {
              try {
                answer.complete(InetAddress.getByName(host));
              } catch (UnknownHostException | RuntimeException e) {
                answer.completeExceptionally(e);
              } finally {
                answer.completeExceptionally(new IOException("the name service failed"));
                ASKED.remove(host, answer); // Java itself caches addresses
              }
            },
            "dfra-resolver-" + host);
    thread.setDaemon(true);
    thread.start();
    return answer;
  }
}
