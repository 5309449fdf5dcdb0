package org.dfra.river.transport;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.Collection;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.io.UnsupportedConstraintException;
import net.jini.jeri.InboundRequest;

/** A request that has arrived, and its response. Used by the worker that serves the connection. */
final class InboundCall implements InboundRequest, MessageOutput.Sender, MessageInput.Source {

  private final ServerConnection connection;
  private final MessageInput request;
  private final MessageOutput response;
  private boolean isAnswered;

  InboundCall(ServerConnection connection, ByteBuffer input, ByteBuffer output) {
    this.connection = connection;
    this.request = new MessageInput(input, this);
    this.response = new MessageOutput(output, this);
  }

  /** There are no permissions without a security manager. */
  @Override
  public void checkPermissions() {}

  @Override
  public InvocationConstraints checkConstraints(InvocationConstraints constraints)
      throws UnsupportedConstraintException {
    return TransportConstraints.check(constraints);
  }

  @Override
  @SuppressWarnings({"rawtypes", "unchecked"}) // as River declares it
  public void populateContext(Collection context) {
    connection.link().addClientTo(context);
  }

  @Override
  public InputStream getRequestInputStream() {
    return request;
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
    connection.send(block);
    isAnswered = isEnd;
  }

  /** The rest of the request is skipped after the response. */
  @Override
  public void closed() {}

  @Override
  public void abort() {
    connection.close();
  }

  /** Whether the whole response was sent. */
  boolean isAnswered() {
    return isAnswered;
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
