package org.dfra.river.remote.schema;

import org.dfra.flow.motor.FuzzyDrive;

/** What clients may call on the server of a fuzzy drive schema. */
public interface RemoteFuzzyDrive extends RemoteSchema, FuzzyDrive {}
