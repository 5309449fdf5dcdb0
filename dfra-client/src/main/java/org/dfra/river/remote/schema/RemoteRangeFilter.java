package org.dfra.river.remote.schema;

import org.dfra.flow.perceptual.RangeFilter;

/** What clients may call on the server of a range filter. */
public interface RemoteRangeFilter extends RemoteSchema, RangeFilter {}
