package org.dfra.river.filter;

import java.io.InputStream;
import java.io.OutputStream;
import java.util.Collection;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.io.UnsupportedConstraintException;
import net.jini.jeri.InboundRequest;

/** A request whose arguments are checked before any of them is deserialized. */
final class ScannedInboundRequest implements InboundRequest {

  private final InboundRequest request;
  private final InputStream arguments;

  ScannedInboundRequest(InboundRequest request, SerialLimits limits) {
    this.request = request;
    this.arguments = ScannedStream.of(request.getRequestInputStream(), limits);
  }

  @Override
  public InputStream getRequestInputStream() {
    return arguments;
  }

  @Override
  public void checkPermissions() {
    request.checkPermissions();
  }

  @Override
  public InvocationConstraints checkConstraints(InvocationConstraints constraints)
      throws UnsupportedConstraintException {
    return request.checkConstraints(constraints);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public void populateContext(Collection context) {
    request.populateContext(context);
  }

  @Override
  public OutputStream getResponseOutputStream() {
    return request.getResponseOutputStream();
  }

  @Override
  public void abort() {
    request.abort();
  }
}
