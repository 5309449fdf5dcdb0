/** One contract, held by the implementation, the proxy beside it and the proxy far from it. */
@NullMarked
package org.dfra.river.contract;

import org.jspecify.annotations.NullMarked;
