package org.dfra.river.remote;

import java.rmi.Remote;
import org.dfra.event.ModuleListener;

/** A listener that is told over the network. Clients need not write one: proxies make them. */
public interface RemoteModuleListener extends ModuleListener, Remote {}
