package org.dfra.river.filter;

import java.io.InputStream;
import java.io.OutputStream;
import java.util.Collection;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.OutboundRequest;

/** A request whose answer has a bounded number of bytes. */
final class BoundedResponse implements OutboundRequest {

  private final OutboundRequest request;
  private final InputStream answer;

  BoundedResponse(OutboundRequest request, long bytes) {
    this.request = request;
    this.answer = new BoundedStream(request.getResponseInputStream(), bytes);
  }

  @Override
  public InputStream getResponseInputStream() {
    return answer;
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public void populateContext(Collection context) {
    request.populateContext(context);
  }

  @Override
  public InvocationConstraints getUnfulfilledConstraints() {
    return request.getUnfulfilledConstraints();
  }

  @Override
  public OutputStream getRequestOutputStream() {
    return request.getRequestOutputStream();
  }

  @Override
  public boolean getDeliveryStatus() {
    return request.getDeliveryStatus();
  }

  @Override
  public void abort() {
    request.abort();
  }
}
