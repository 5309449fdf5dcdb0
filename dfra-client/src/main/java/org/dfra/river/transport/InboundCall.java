package org.dfra.river.transport;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.SequenceInputStream;
import java.nio.ByteBuffer;
import java.util.Collection;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.io.UnsupportedConstraintException;
import net.jini.jeri.InboundRequest;
import org.dfra.river.access.MeteredRequest;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.ChannelPeer;
import org.jspecify.annotations.Nullable;

/**
 * A request that has arrived, and its response. Used by the worker that serves the connection.
 *
 * <p>JERI has an object in each port that counts the references of clients, for distributed garbage
 * collection. Its dispatcher is JERI's own: nobody filters what it reads, or asks who calls. No
 * exporter of DFRA needs it, so calls to it get the answer that there is no such object, whatever
 * was exported at the port.
 */
final class InboundCall
    implements InboundRequest, MeteredRequest, MessageOutput.Sender, MessageInput.Source {

  /** JERI's ID of the object for garbage collection, d32cd1bc-273c-11b2-8841-080020c9e4a1. */
  private static final long COLLECTOR_HIGH = 0xd32c_d1bc_273c_11b2L;

  private static final long COLLECTOR_LOW = 0x8841_0800_20c9_e4a1L;

  /** JERI's answer to a call of an object that is not exported. */
  private static final int NO_SUCH_OBJECT = 0;

  private static final int ID_BYTES = 16;

  private final ServerConnection connection;
  private final MessageInput request;
  private InputStream toRead;
  private final MessageOutput response;
  private @Nullable ByteBuffer end; // the response's last block, once the response is complete
  private @Nullable Runnable onEnd;

  InboundCall(ServerConnection connection, ByteBuffer input, ByteBuffer output) {
    this.connection = connection;
    this.request = new MessageInput(input, this);
    this.toRead = request;
    this.response = new MessageOutput(output, this);
  }

  /** There are no permissions without a security manager. */
  @Override
  public void checkPermissions() {}

  @Override
  public InvocationConstraints checkConstraints(InvocationConstraints constraints)
      throws UnsupportedConstraintException {
    @Nullable ChannelIdentity identity = connection.port().identity();
    @Nullable ChannelPeer client = connection.link().partner();
    return identity == null || client == null
        ? TransportConstraints.checkPlain(constraints)
        : TransportConstraints.checkEncrypted(
            constraints, client.subject().getPrincipals(), identity.subject().getPrincipals());
  }

  @Override
  @SuppressWarnings({"rawtypes", "unchecked"}) // as River declares it
  public void populateContext(Collection context) {
    connection.link().addClientTo(context);
  }

  @Override
  public long takeBytes() {
    return connection.takeBytes();
  }

  @Override
  public void whenEnded(Runnable action) {
    onEnd = action;
  }

  @Override
  public InputStream getRequestInputStream() {
    return toRead;
  }

  @Override
  public OutputStream getResponseOutputStream() {
    return response;
  }

  @Override
  public void receive(ByteBuffer buffer) throws IOException {
    connection.receive(buffer);
  }

  @Override
  public IOException refused() {
    return new IOException("a client sent a block that only servers send");
  }

  @Override
  public void send(ByteBuffer block, boolean isEnd) throws IOException {
    if (isEnd) {
      end = block;
    } else {
      connection.send(block);
    }
  }

  /** The rest of the request is skipped after the response. */
  @Override
  public void closed() {}

  /**
   * {@inheritDoc} River aborts calls of an object that is unexported by force, and interrupts their
   * threads, also when the call has ended and River's dispatcher has not. Then the response counts:
   * other calls use the connection.
   */
  @Override
  public void abort() {
    if (end == null) {
      connection.close();
    }
  }

  /** Whether it is a call to the object for garbage collection; the request is not read yet. */
  boolean isForCollector() throws IOException {
    int count = request.await(ID_BYTES);
    if (count == ID_BYTES) {
      return request.peekLong(0) == COLLECTOR_HIGH && request.peekLong(8) == COLLECTOR_LOW;
    } else if (request.isInLastBlock()) {
      return false; // too short for any object's ID
    }
    byte[] id = request.readNBytes(ID_BYTES); // in several blocks, which no client of DFRA sends
    toRead = new SequenceInputStream(new ByteArrayInputStream(id), request);
    ByteBuffer both = ByteBuffer.wrap(id);
    return id.length == ID_BYTES
        && both.getLong() == COLLECTOR_HIGH
        && both.getLong() == COLLECTOR_LOW;
  }

  /** Answers that there is no such object. */
  void refuseCollector() throws IOException {
    response.write(NO_SUCH_OBJECT);
    response.close();
  }

  /**
   * Sends the rest of the response. To be called when the dispatcher has returned: nobody
   * interrupts the thread any more, which would close the connection.
   *
   * @return false if there is no response: the dispatcher has aborted the call
   */
  boolean answer() throws IOException {
    if (end == null) {
      return false;
    }
    connection.send(end);
    return true;
  }

  /** Nothing more is sent. */
  void ended() {
    if (onEnd != null) {
      onEnd.run();
    }
  }

  /**
   * Skips what was not read of the request.
   *
   * @param maxBytes of it
   * @return false if there is more
   */
  boolean skipRest(long maxBytes) throws IOException {
    return request.skipRest(maxBytes);
  }
}
