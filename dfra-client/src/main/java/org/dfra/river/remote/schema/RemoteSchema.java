package org.dfra.river.remote.schema;

import org.dfra.flow.Schema;
import org.dfra.river.remote.RemoteModule;

/** What clients may call on any schema's server. */
public interface RemoteSchema extends RemoteModule, Schema {}
