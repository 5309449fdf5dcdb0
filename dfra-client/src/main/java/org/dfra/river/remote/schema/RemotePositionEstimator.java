package org.dfra.river.remote.schema;

import org.dfra.flow.perceptual.PositionEstimator;

/** What clients may call on the server of a position estimator. */
public interface RemotePositionEstimator extends RemoteSchema, PositionEstimator {}
