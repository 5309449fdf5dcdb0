package org.dfra.river.loading;

import java.net.http.HttpResponse.BodySubscriber;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Flow.Subscription;
import org.jspecify.annotations.Nullable;

/** A body of bounded length; a longer one is aborted as soon as it exceeds the limit. */
final class BoundedBody implements BodySubscriber<byte[]> {

  private final CodebaseUrl url;
  private final long allowed;
  private final List<ByteBuffer> parts = new ArrayList<>();
  private final CompletableFuture<byte[]> body = new CompletableFuture<>();
  private @Nullable Subscription subscription;
  private long length;

  BoundedBody(CodebaseUrl url, long allowed) {
    this.url = url;
    this.allowed = allowed;
  }

  @Override
  public CompletionStage<byte[]> getBody() {
    return body;
  }

  @Override
  public void onSubscribe(Subscription subscribed) {
    subscription = subscribed;
    subscribed.request(Long.MAX_VALUE);
  }

  @Override
  public void onNext(List<ByteBuffer> buffers) {
    for (ByteBuffer buffer : buffers) {
      length += buffer.remaining();
      parts.add(buffer);
    }
    if (length > allowed) {
      parts.clear();
      if (subscription != null) {
        subscription.cancel();
      }
      body.completeExceptionally(
          new CodeRefusedException(
              "codebase "
                  + url.text()
                  + " refused: the jar is longer than "
                  + allowed
                  + " bytes; raise download.bytes to load it"));
    }
  }

  @Override
  public void onError(Throwable error) {
    body.completeExceptionally(error);
  }

  @Override
  public void onComplete() {
    if (length > allowed) {
      return;
    }
    byte[] whole = new byte[(int) length];
    ByteBuffer into = ByteBuffer.wrap(whole);
    parts.forEach(into::put);
    body.complete(whole);
  }
}
