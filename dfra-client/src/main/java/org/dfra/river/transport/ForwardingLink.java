package org.dfra.river.transport;

import java.io.IOException;
import java.nio.channels.SelectableChannel;
import java.util.Collection;
import org.dfra.river.identity.ChannelPeer;
import org.jspecify.annotations.Nullable;

/** A link around another one. What a subclass does not change, the other one does. */
abstract class ForwardingLink implements Link {

  /** The other one. */
  final Link link;

  ForwardingLink(Link link) {
    this.link = link;
  }

  @Override
  public void setBlocking(boolean blocking) throws IOException {
    link.setBlocking(blocking);
  }

  @Override
  public void endOutput() throws IOException {
    link.endOutput();
  }

  @Override
  public void endInput() throws IOException {
    link.endInput();
  }

  @Override
  public boolean hasReceived() {
    return link.hasReceived();
  }

  @Override
  public int held() {
    return link.held();
  }

  @Override
  public @Nullable ChannelPeer partner() {
    return link.partner();
  }

  @Override
  public long bytes() {
    return link.bytes();
  }

  @Override
  public SelectableChannel channel() {
    return link.channel();
  }

  @Override
  public Peer peer() {
    return link.peer();
  }

  @Override
  public void addClientTo(Collection<Object> context) {
    link.addClientTo(context);
  }

  @Override
  public void close() throws IOException {
    link.close();
  }
}
