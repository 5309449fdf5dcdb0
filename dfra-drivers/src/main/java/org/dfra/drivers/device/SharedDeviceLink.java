package org.dfra.drivers.device;

import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.link.LinkKeeper;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A line to a device, shared by the modules of a virtual machine that name the same link: a serial
 * port has one owner only. It is opened for the first module that joins, and closed when the last
 * one leaves. A protocol extends it, and keeps its lines in a {@link SharedLinkRegistry}; a module
 * joins and leaves by a {@link SharedLinkHandle}.
 *
 * <p>Threads: one reader, owned from the first module to the last; it tells the members.
 *
 * @param <M> what the protocol tells its members and asks of them
 */
public abstract class SharedDeviceLink<M extends SharedLinkClient> {

  /** Where what befalls the line is told. */
  protected final Logger log;

  private final SharedLinkRegistry<M, ?> registry;
  private final String name;
  private final ModuleContext context;
  private final SharedLinkClients<M> clients = new SharedLinkClients<>();

  /**
   * @param registry where it is kept
   * @param name of the protocol; the reader is called {@code name reader}
   * @param context of the first module that joins
   */
  protected SharedDeviceLink(
      SharedLinkRegistry<M, ?> registry, String name, ModuleContext context) {
    this.registry = registry;
    this.name = name;
    this.context = context;
    this.log = LoggerFactory.getLogger("dfra." + context.robot() + "." + name);
  }

  /** The line for a protocol, by the parameters of the first module; not started. */
  protected final DeviceLink newDeviceLink(
      DeviceProtocol protocol, Ticker ticker, LinkKeeper.@Nullable Source source) {
    ModuleContext shared =
        new ModuleContext(context.robot(), name, context.parameters(), context.clock());
    return new DeviceLink(shared, protocol, ticker, source, log);
  }

  /** The line itself, to be examined. */
  public abstract DeviceLink deviceLink();

  /** Who shares it. */
  protected final SharedLinkClients<M> clients() {
    return clients;
  }

  /** The path of the module that joined first, whose parameters it goes by. */
  protected final String firstClientPath() {
    return context.path();
  }

  /** A module has joined: opens the line where that was the first. */
  protected void start() {
    deviceLink().start();
  }

  /** The last module has left. */
  protected void close() {
    deviceLink().close();
  }

  /** Leaves; returns when the member will not be told anything any more. */
  final void leave(M client) {
    registry.leave(client, this);
  }
}
