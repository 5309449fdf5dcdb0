package org.dfra.benchmarks.micro;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Collection;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.InboundRequest;
import net.jini.jeri.OutboundRequest;

/** A call whose bytes were recorded, seen from either end; nothing is sent. */
final class RecordedRequest implements InboundRequest, OutboundRequest {

  private final InputStream bytes;

  /**
   * @param recording the object stream of a call's arguments or of its result
   * @param from index of the stream's first byte
   */
  RecordedRequest(byte[] recording, int from) {
    this.bytes = new ByteArrayInputStream(recording, from, recording.length - from);
  }

  @Override
  public InputStream getRequestInputStream() {
    return bytes;
  }

  @Override
  public InputStream getResponseInputStream() {
    return bytes;
  }

  @Override
  public OutputStream getRequestOutputStream() {
    return OutputStream.nullOutputStream();
  }

  @Override
  public OutputStream getResponseOutputStream() {
    return OutputStream.nullOutputStream();
  }

  @Override
  public void checkPermissions() {}

  @Override
  public InvocationConstraints checkConstraints(InvocationConstraints constraints) {
    return InvocationConstraints.EMPTY;
  }

  @Override
  public InvocationConstraints getUnfulfilledConstraints() {
    return InvocationConstraints.EMPTY;
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public void populateContext(Collection context) {}

  @Override
  public boolean getDeliveryStatus() {
    return true;
  }

  @Override
  public void abort() {}
}
