package org.dfra.river.remote.schema;

import org.dfra.flow.perceptual.MineDetector;

/** What clients may call on the server of a mine detector. */
public interface RemoteMineDetector extends RemoteSchema, MineDetector {}
