package org.dfra.river.filter;

import java.io.InputStream;
import java.io.OutputStream;
import java.util.Collection;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.OutboundRequest;

/** A request whose response is checked before any of it is deserialized. */
final class ScannedOutboundRequest implements OutboundRequest {

  private final OutboundRequest request;
  private final InputStream answer;

  ScannedOutboundRequest(OutboundRequest request, SerialLimits limits) {
    this.request = request;
    this.answer = ScannedStream.of(request.getResponseInputStream(), limits);
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
