package org.dfra.river.remote.schema;

import org.dfra.flow.perceptual.HeadingError;

/** What clients may call on the server of a schema of the heading error. */
public interface RemoteHeadingError extends RemoteSchema, HeadingError {}
