package org.dfra.river.transport;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.AsynchronousCloseException;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import org.jspecify.annotations.Nullable;

/**
 * A link that waits by a selector instead of a blocking read. For Unix-domain sockets: Linux wakes
 * a thread that is blocked in a read of one also when the peer takes bytes out of the socket, so
 * that a call wakes each side twice. A selector is woken by bytes only.
 *
 * <p>It has two further file descriptors from the first wait on.
 */
final class PollingLink extends ForwardingLink {

  private volatile boolean blocking = true;

  /** At a selector of its own, from the first wait on. */
  @GuardedBy("this")
  private @Nullable SelectionKey key;

  @GuardedBy("this")
  private boolean closed;

  /**
   * Makes another link wait so.
   *
   * @param link whose channel is made non-blocking
   */
  PollingLink(Link link) throws IOException {
    super(link);
    link.setBlocking(false);
  }

  @Override
  public int read(ByteBuffer into) throws IOException {
    if (!blocking) {
      return link.read(into);
    }
    while (true) {
      await(SelectionKey.OP_READ);
      int count = link.read(into);
      if (count != 0) {
        return count;
      }
    }
  }

  @Override
  public int write(ByteBuffer from) throws IOException {
    if (blocking) {
      checkInterrupted();
    }
    int count = link.write(from);
    while (from.hasRemaining() && blocking) {
      await(SelectionKey.OP_WRITE);
      count += link.write(from);
    }
    return count;
  }

  private void await(int operation) throws IOException {
    try {
      SelectionKey waiting = key();
      if (waiting.interestOps() != operation) {
        waiting.interestOps(operation);
      }
      int unused = waiting.selector().select();
      waiting.selector().selectedKeys().clear();
    } catch (ClosedSelectorException | CancelledKeyException e) {
      throw (IOException) new AsynchronousCloseException().initCause(e);
    }
    checkInterrupted();
  }

  /** A blocking channel is closed by the interruption of its thread. */
  private void checkInterrupted() throws IOException {
    if (Thread.currentThread().isInterrupted()) {
      close();
      throw new ClosedByInterruptException();
    }
  }

  private synchronized SelectionKey key() throws IOException {
    if (closed) {
      throw new AsynchronousCloseException();
    }
    SelectionKey registered = key;
    if (registered == null) {
      registered = register();
      key = registered;
    }
    return registered;
  }

  private SelectionKey register() throws IOException {
    Selector selector = Selector.open();
    try {
      return link.channel().register(selector, SelectionKey.OP_READ);
    } catch (IOException | RuntimeException e) { // closed meanwhile
      selector.close();
      throw e;
    }
  }

  @Override
  public void setBlocking(boolean blocking) {
    this.blocking = blocking;
  }

  @Override
  public void close() throws IOException {
    @Nullable SelectionKey ending;
    synchronized (this) {
      closed = true;
      ending = key;
    }
    try {
      link.close();
    } finally {
      if (ending != null) {
        ending.selector().close(); // wakes a thread that waits
      }
    }
  }
}
