package org.dfra.river.transport;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.jeri.InboundRequest;
import net.jini.jeri.OutboundRequest;
import net.jini.jeri.ServerEndpoint;
import net.jini.jeri.ServerEndpoint.ListenHandle;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.security.Caller;
import org.jspecify.annotations.Nullable;

/** A server that answers with the bytes of the request, and keeps what it knew of the callers. */
final class RecordingServer implements AutoCloseable {

  static final String HOST = "127.0.0.1";

  private final List<ListenHandle> handles = new ArrayList<>();
  private final List<List<Object>> contexts = new CopyOnWriteArrayList<>();
  private final TransportEndpoint endpoint;

  private RecordingServer(ServerEndpoint listening) {
    try {
      endpoint =
          (TransportEndpoint)
              listening.enumerateListenEndpoints(
                  each -> {
                    ListenHandle handle = each.listen(this::echo);
                    handles.add(handle);
                    return handle.getCookie();
                  });
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  /** One that encrypts. */
  static RecordingServer as(ChannelIdentity identity) {
    return new RecordingServer(endpoint(identity));
  }

  /** One that encrypts, at a port. */
  static RecordingServer at(int port, ChannelIdentity identity) {
    return new RecordingServer(
        CurrentIdentity.callAs(identity, () -> new TransportServerEndpoint(HOST, port)));
  }

  /** One that does not encrypt. */
  static RecordingServer open() {
    return new RecordingServer(new TransportServerEndpoint(HOST, 0));
  }

  /** An endpoint to listen on. */
  static ServerEndpoint endpoint(ChannelIdentity identity) {
    return CurrentIdentity.callAs(identity, () -> new TransportServerEndpoint(HOST, 0));
  }

  private void echo(InboundRequest request) {
    Collection<Object> context = new ArrayList<>();
    request.populateContext(context);
    contexts.add(List.copyOf(context));
    try (InputStream in = request.getRequestInputStream();
        OutputStream out = request.getResponseOutputStream()) {
      byte[] bytes = in.readAllBytes();
      out.write(bytes);
    } catch (IOException e) {
      request.abort();
    }
  }

  int port() {
    return endpoint.port();
  }

  /** The number of requests that were dispatched. */
  int dispatched() {
    return contexts.size();
  }

  /** An element of the context of the last request. */
  <T> T last(Class<T> type) {
    return of(contexts.get(contexts.size() - 1), type);
  }

  /** The callers, from one on. */
  List<Caller> callersFrom(int first) {
    return contexts.subList(first, contexts.size()).stream()
        .map(each -> of(each, Caller.class))
        .toList();
  }

  private static <T> T of(List<Object> context, Class<T> type) {
    return context.stream().filter(type::isInstance).map(type::cast).findFirst().orElseThrow();
  }

  /** The client's side of it. */
  TransportEndpoint from(@Nullable ChannelIdentity client) {
    return client == null
        ? new TransportEndpoint(HOST, port())
        : CurrentIdentity.callAs(client, () -> new TransportEndpoint(HOST, port()));
  }

  static byte[] call(TransportEndpoint to) throws IOException {
    return call(to, InvocationConstraints.EMPTY);
  }

  static byte[] call(TransportEndpoint to, InvocationConstraints constraints) throws IOException {
    OutboundRequest request = to.newRequest(constraints).next();
    try (OutputStream out = request.getRequestOutputStream()) {
      out.write(new byte[] {1, 2, 3});
    }
    try (InputStream in = request.getResponseInputStream()) {
      return in.readAllBytes();
    }
  }

  @Override
  public void close() {
    handles.forEach(ListenHandle::close);
  }
}
