package org.dfra.river.loading;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.river.loading.CodeTrust.DownloadLimits;
import org.dfra.river.transport.CallInFlight;

/** Fetches a jar by HTTP into memory, within limits; follows no redirect and uses no proxy. */
final class JarDownload {

  /** Shared: it has a thread of its own, which ends when the client becomes unreachable. */
  private static final class Shared {
    static final HttpClient CLIENT =
        HttpClient.newBuilder()
            .version(HttpClient.Version.HTTP_1_1)
            .followRedirects(HttpClient.Redirect.NEVER)
            .proxy(HttpClient.Builder.NO_PROXY)
            .build();
  }

  private final DownloadLimits limits;

  JarDownload(DownloadLimits limits) {
    this.limits = limits;
  }

  /**
   * Fetches the bytes that match the URL's digest.
   *
   * @throws CodeRefusedException if the response is not a jar within the limits, or its bytes do
   *     not match the digest
   * @throws IOException if it does not answer, or not in time
   */
  byte[] fetch(CodebaseUrl url) throws IOException {
    byte[] bytes = get(url);
    String digest = Digests.sha256(bytes);
    if (!digest.equals(url.digest())) {
      throw new CodeRefusedException(
          "codebase "
              + url.text()
              + " refused: what is served there has SHA-256 "
              + digest
              + ", so it was altered, or rebuilt since; restart the class server and the process"
              + " that named this codebase");
    }
    return bytes;
  }

  private byte[] get(CodebaseUrl url) throws IOException {
    // With the digest, like River's own clients: the server may have this jar and a newer one.
    URI asked = URI.create(url.location() + ClassServer.DIGEST + url.digest());
    HttpRequest request = HttpRequest.newBuilder(asked).timeout(limits.timeout()).build();
    CompletableFuture<HttpResponse<byte[]>> answer =
        Shared.CLIENT.sendAsync(
            request,
            head -> {
              if (head.statusCode() != 200) {
                throw new CodeRefusedException(
                    "codebase "
                        + url.text()
                        + " refused: the server answers "
                        + head.statusCode()
                        + (head.statusCode() / 100 == 3 ? " and redirects are not followed" : "")
                        + "; see whether it serves that jar");
              }
              return new BoundedBody(url, limits.jarBytes());
            });
    CallInFlight.attachConnection(() -> answer.cancel(true)); // of a call whose result needs it
    try {
      return answer.get(limits.timeout().toMillis(), TimeUnit.MILLISECONDS).body();
    } catch (CancellationException e) {
      throw late(url, e);
    } catch (TimeoutException e) {
      answer.cancel(true);
      throw late(url, e);
    } catch (InterruptedException e) {
      answer.cancel(true);
      Thread.currentThread().interrupt();
      throw new IOException("interrupted while " + url.text() + " was fetched", e);
    } catch (ExecutionException e) {
      throw failure(url, e);
    }
  }

  private IOException failure(CodebaseUrl url, ExecutionException e) {
    for (Throwable at = e; at != null; at = at.getCause()) {
      if (at instanceof CodeRefusedException refused) {
        throw refused;
      }
      if (at instanceof java.net.http.HttpTimeoutException) {
        return late(url, at);
      }
    }
    return new IOException(
        "codebase "
            + url.text()
            + " cannot be fetched ("
            + e.getCause()
            + "); see whether its class server runs",
        e);
  }

  private IOException late(CodebaseUrl url, Throwable cause) {
    return new IOException(
        "codebase "
            + url.text()
            + " did not come within "
            + limits.timeout().toMillis()
            + " ms; see whether its class server runs, or raise download.millis",
        cause);
  }
}
